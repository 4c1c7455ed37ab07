#include "viz/chart/ticks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace furnas {
namespace {

/// Tolerance for rounding: an end of a stretch this close to a mark counts as on the mark.
constexpr double hair = 1e-9;

/// m times 10^n, m in 1 ... 9.
std::string power_label(int m, int n) {
  if (std::abs(n) <= 3) return fmt::format("{:.{}f}", m * std::pow(10.0, n), std::max(0, -n));
  const std::string power = n < 0 ? fmt::format("−{}", -n) : std::to_string(n);
  return m == 1 ? fmt::format("10^{{{}}}", power) : fmt::format("{}·10^{{{}}}", m, power);
}

}  // namespace

double tick_distance(double length, int most) {
  const double least = length / most * (1 - hair);
  const double power = std::pow(10.0, std::floor(std::log10(least)));
  for (const double m : {1.0, 2.0, 5.0})
    if (m * power >= least) return m * power;
  return 10 * power;
}

Stretch widened_to_ticks(const Stretch& stretch, int most) {
  // The widened stretch may need a larger distance of marks, which is then used.
  const double rough = tick_distance(stretch.high - stretch.low, most);
  const auto ends = [&](double d) {
    return Stretch{d * std::floor(stretch.low / d + hair), d * std::ceil(stretch.high / d - hair)};
  };
  const Stretch wide = ends(rough);
  return ends(tick_distance(wide.high - wide.low, most));
}

std::vector<Tick> linear_ticks(const Stretch& stretch, int most) {
  const double distance = tick_distance(stretch.high - stretch.low, most);
  const int decimals = std::max(0, -static_cast<int>(std::floor(std::log10(distance) + hair)));
  const bool plain = decimals <= 5 && std::max(std::abs(stretch.low), std::abs(stretch.high)) < 1e6;
  std::vector<Tick> ticks;
  const auto first = static_cast<std::int64_t>(std::ceil(stretch.low / distance - hair));
  const auto last = static_cast<std::int64_t>(std::floor(stretch.high / distance + hair));
  for (std::int64_t n = first; n <= last; ++n) {
    const double at = static_cast<double>(n) * distance, size = std::abs(at);
    const std::string label = plain ? fmt::format("{:.{}f}", size, decimals) : fmt::format("{:g}", size);
    ticks.push_back({at, (n < 0 ? "−" : "") + label});
  }
  return ticks;
}

std::vector<Tick> logarithmic_ticks(const Stretch& stretch, int most) {
  const int first = static_cast<int>(std::floor(stretch.low + hair));
  const int last = static_cast<int>(std::ceil(stretch.high - hair));
  const int stride = std::max(1, (last - first + most) / most);
  const bool narrow = stretch.high - stretch.low < 2;
  std::vector<Tick> ticks;
  for (int n = first; n <= last; ++n)
    for (int m = 1; m < 10; ++m) {
      const double at = n + std::log10(static_cast<double>(m));
      if (at < stretch.low - hair || at > stretch.high + hair) continue;
      const bool labelled = m == 1 ? n % stride == 0 : narrow && (m == 2 || m == 5);
      if (stride == 1 || m == 1) ticks.push_back({at, labelled ? power_label(m, n) : ""});
    }
  return ticks;
}

}  // namespace furnas
