#pragma once

#include <span>
#include <string_view>

namespace furnas {

/// What a column, field or array of a file is. It stands beside what writes it, so that `furnas schema
/// --outputs` can say of every number what it means.
struct OutputField {
  std::string_view name;
  std::string_view unit;  ///< empty: a pure number or a word
  std::string_view of;    ///< what it is counted over: "total", "per particle", "share of the contacts", ...
  std::string_view doc;   ///< what it means and what its sign says, in a phrase
};

}  // namespace furnas
