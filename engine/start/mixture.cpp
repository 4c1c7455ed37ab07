#include "engine/start/mixture.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "engine/base/require.h"
#include "engine/base/sphere.h"
#include "engine/start/gas.h"

namespace furnas {

double small_count(const Mixture& m) {
  return std::round(static_cast<double>(m.large) * m.size_ratio * m.size_ratio * m.size_ratio *
                    m.small_fraction / (1 - m.small_fraction));
}

double large_diameter(const Mixture& m) { return small_count(m) > 0 ? m.size_ratio : 1; }

Packing dilute_start(const Mixture& m) {
  if (m.large < 1)
    throw InputError(std::to_string(m.large) + " large spheres are wanted; allowed: 1 or more");
  if (!(std::isfinite(m.size_ratio) && m.size_ratio >= 1))
    throw InputError("the size ratio is " + std::to_string(m.size_ratio) + "; allowed: 1 or more");
  if (!(m.small_fraction >= 0 && m.small_fraction < 1))
    throw InputError("the share of the small spheres is " + std::to_string(m.small_fraction) +
                     "; allowed: from 0 to below 1");
  const double all = static_cast<double>(m.large) + small_count(m);
  if (!(all <= static_cast<double>(most_particles)))
    throw InputError((all < 1e18 ? std::to_string(std::llround(all)) : "more than 1e18") +
                     " spheres are wanted; at most " + std::to_string(most_particles) + " can be numbered");
  const auto large = static_cast<std::size_t>(m.large);
  const auto small = static_cast<std::size_t>(small_count(m));
  const double large_radius = 0.5 * large_diameter(m);
  const double small_radius = 0.5;
  std::vector<double> radii(large + small, small_radius);
  std::fill_n(radii.begin(), large, large_radius);
  Packing p = dilute_gas(radii, {.start_fraction = m.start_fraction,
                                 .seed = m.seed,
                                 .sphere_volume = static_cast<double>(large) * sphere_volume(large_radius) +
                                                  static_cast<double>(small) * sphere_volume(small_radius)});
  // The species is set explicitly, so that both species also exist if the size ratio is 1.
  for (std::size_t k = 0; k < p.size(); ++k) p.species[k] = k < large ? Species::large : Species::small;
  return p;
}

void set_masses(Packing& p, double exponent) {
  for (std::size_t k = 0; k < p.size(); ++k)
    p.mass[k] = sphere_mass(0.5) * std::pow(2 * p.radius[k], exponent);
}

}  // namespace furnas
