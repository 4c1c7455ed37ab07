#include "cases/program/sweep/finite_size.h"

#include <fmt/format.h>

namespace furnas {

std::optional<double> finite_size_shift(const Point&) { return {}; }

std::string finite_size_text(const Point& point) {
  if (!point.mean_phi_J) return {};
  const auto shift = finite_size_shift(point);
  return shift ? fmt::format("{:+.4f}", *shift) : "unknown";
}

}  // namespace furnas
