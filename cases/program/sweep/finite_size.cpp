#include "cases/program/sweep/finite_size.h"

#include <fmt/format.h>

#include <cmath>

namespace furnas {

std::optional<SizeShift> size_shift(const Point& p) {
  constexpr std::int64_t fewest = 500;
  constexpr double highest_pressure = 1e-3;
  const bool equal_spheres = p.small == 0 && p.large >= fewest;
  if (!equal_spheres || !(p.pressure <= highest_pressure)) return {};
  // Without friction phi_J of N spheres is lower by 0.08/sqrt(N) than in large samples: 0.0036 with N = 500,
  // 0.0018 with N = 2000.
  constexpr double amplitude = 0.08;
  if (p.friction == 0) return SizeShift{amplitude / std::sqrt(static_cast<double>(p.large)), 1e-3};
  // With friction 0.3 the means of 500, 1000 and 2000 spheres agree within their intervals.
  if (p.friction == 0.3) return SizeShift{0, 2e-3};
  return {};
}

std::string finite_size_text(const Point& point) {
  if (!point.mean_phi_J) return {};
  const auto shift = size_shift(point);
  return shift ? fmt::format("{:+.4f} +- {:.4f}", shift->value, shift->uncertainty) : "unknown";
}

}  // namespace furnas
