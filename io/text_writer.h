#pragma once

#include <fmt/format.h>

#include <iterator>
#include <utility>

#include "engine/base/vec3.h"
#include "io/atomic_file.h"

/// "x y z", or "x,y,z" for the format `{:,}`; the shortest digits that read back as the same numbers.
template <>
struct fmt::formatter<furnas::Vec3<double>> {
  constexpr auto parse(format_parse_context& context) {
    auto at = context.begin();
    if (at != context.end() && *at != '}') separator = *at++;
    return at;
  }
  template <class Context>
  auto format(const furnas::Vec3<double>& v, Context& context) const {
    return fmt::format_to(context.out(), "{}{}{}{}{}", v.x, separator, v.y, separator, v.z);
  }
  char separator = ' ';
};

namespace furnas {

/// Appends formatted text to a file. A real number `{}` is written with the fewest digits that read back as
/// the same number.
template <class... Args>
void print(AtomicFile& file, fmt::format_string<Args...> format, Args&&... args) {
  fmt::memory_buffer text;
  fmt::format_to(std::back_inserter(text), format, std::forward<Args>(args)...);
  file.write({text.data(), text.size()});
}

}  // namespace furnas
