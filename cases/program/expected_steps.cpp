#include "cases/program/expected_steps.h"

#include <algorithm>
#include <cmath>

#include "io/case_protocol.h"

namespace furnas {
namespace {

/// With friction packings near the densest mixture take the longest, because a few bridges of spheres carry
/// the load there; more large spheres have more bridges. Where the large spheres alone carry the load, they
/// take long to come together at large size ratios.
double steps_with_friction(const Mixture& mixture) {
  constexpr double many = 100;  // large spheres
  const double alpha = large_diameter(mixture), f_s = mixture.small_fraction;
  const bool sharp = alpha >= 7;  // the maximum, as that of the model
  const double densest = sharp ? 0.30 : 0.33, width = sharp && f_s > densest ? 0.08 : 0.12;
  const double off = (f_s - densest) / width;
  const double bridges = std::sqrt(std::clamp(static_cast<double>(mixture.large) / many, 0.1, 1.0));
  const double at_the_maximum = alpha > 1 ? std::min(1e4 * alpha * alpha, 5e5) * bridges : 0;
  return 2.2e4 * std::pow(alpha, f_s < densest ? 0.75 : 0.4) + at_the_maximum * std::exp(-off * off);
}

/// Without friction packings of many spheres that carry load take the longest: all spheres, or, below the
/// densest mixture of size ratio 3 and more, the large ones alone.
double steps_without_friction(const Case& c, double particles) {
  constexpr double settles = 5e5, wide = 4e-3;  // few packings have no such bound on phi by then
  const double alpha = large_diameter(mixture_of(c)), f_s = c.mixture.small_fraction;
  const bool large_ones_alone = alpha >= 3 && f_s < (alpha < 7 ? 0.2 : 0.25);
  const double carriers = large_ones_alone ? static_cast<double>(c.mixture.large) : particles;
  const double steps = std::max(3.5e4 * std::pow(alpha, 0.35), 6e4 * std::pow(carriers / 1000, 0.75));
  return c.stop.phi_error >= wide ? std::min(steps, settles) : steps;
}

}  // namespace

/// The constants fit the samples of docs/results/study (size ratio 1 to 20, 126 to 130 000 spheres). A
/// shorter time step needs more steps.
double expected_steps(const Case& c, double particles) {
  const bool minimized = c.stop.minimizer && c.stop.criterion == "rest";
  const double steps = c.contact.friction > 0 ? steps_with_friction(mixture_of(c))
                       : minimized            ? steps_without_friction(c, particles)
                                              : 1e5 * std::sqrt(std::max(particles / 500, 1.0));
  const Protocol protocol = protocol_of(c);
  const double usual = time_step_of({.contact = protocol.contact}) / time_step_of(protocol);
  return std::min(steps * std::max(usual, 1.0), static_cast<double>(c.stop.steps));
}

}  // namespace furnas
