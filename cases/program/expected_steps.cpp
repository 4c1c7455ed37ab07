#include "cases/program/expected_steps.h"

#include <algorithm>
#include <cmath>

#include "io/case_protocol.h"

namespace furnas {

/// From samples of size ratio 1 to 20 (docs/results/performance.md, "Steps to a verdict"). With friction,
/// packings near the densest mixture take the longest, because a few bridges of spheres carry the load there.
/// Without friction it is packings of many spheres that carry load: all spheres, or, below the densest
/// mixture of size ratio 3 and more, the large ones alone. A shorter time step needs more steps.
double expected_steps(const Case& c, double particles) {
  const double alpha = c.mixture.size_ratio, f_s = c.mixture.small_fraction;
  const double off = (f_s - 0.33) / 0.12;
  const double near_the_maximum = std::min(1e4 * alpha * alpha, 3e5) * std::exp(-off * off);
  const bool large_ones_alone = alpha >= 3 && f_s < 0.2;
  const double carriers = large_ones_alone ? static_cast<double>(c.mixture.large) : particles;
  const bool minimized = c.stop.minimizer && c.stop.criterion == "rest";
  const double steps = c.contact.friction > 0 ? 3e4 + near_the_maximum
                       : minimized            ? 6e4 * std::pow(std::max(carriers / 1000, 1.0), 0.75)
                                              : 1e5 * std::sqrt(std::max(particles / 500, 1.0));
  const Protocol protocol = protocol_of(c);
  const double usual = time_step_of({.contact = protocol.contact}) / time_step_of(protocol);
  return std::min(steps * std::max(usual, 1.0), static_cast<double>(c.stop.steps));
}

}  // namespace furnas
