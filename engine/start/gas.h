#pragma once

#include <cstdint>
#include <vector>

#include "engine/state/packing.h"

namespace furnas {

/// Options for a random gas of spheres.
struct GasOptions {
  double start_fraction = 0.05;  ///< packing fraction of the gas
  std::uint64_t seed = 1;
  double sphere_volume = 0;  ///< of all spheres [d_s^3]; 0: computed from the radii
};

/// A gas of spheres of these radii [d_s] in a cubic cell. The spheres have density 1, are at rest and do not
/// touch. They are placed by random sequential addition, beginning with the largest: each sphere gets random
/// positions until one is free. Particle k has the k-th of the given radii. The species follow the sizes.
/// Throws InputError for a radius or a packing fraction that is not above zero and finite, when no free place
/// is found, when the cell is not wider than the largest sphere, and for no or more than 2^31 - 1 spheres.
Packing dilute_gas(const std::vector<double>& radii, const GasOptions& options);

}  // namespace furnas
