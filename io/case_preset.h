#pragma once

#include <span>
#include <string_view>
#include <vector>

namespace furnas {

/// A name for the values of several keys, which a case may still set one by one.
struct Preset {
  std::string_view name;
  std::string_view does;  ///< one line
  std::vector<std::string_view>
      assignments;  ///< "table.key=value", for the keys that differ from the defaults
};

/// All presets but "none", in the order in which they are listed.
std::span<const Preset> presets();

/// The assignments of a preset; none for "none".
std::span<const std::string_view> assignments_of(std::string_view preset);

}  // namespace furnas
