#pragma once

#include <string_view>

namespace furnas {

/// Describes a column, field or array of a file. The description is declared beside the code that writes the
/// numbers, so that `furnas schema --outputs` can explain every number.
struct OutputField {
  std::string_view name;
  std::string_view unit;  ///< empty: a pure number or a word
  std::string_view of;    ///< what it is counted over: "total", "per particle", "share of the contacts", ...
  std::string_view doc;   ///< its meaning and the meaning of its sign, in a phrase
};

}  // namespace furnas
