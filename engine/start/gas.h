#pragma once

#include <cstdint>
#include <vector>

#include "engine/state/packing.h"

namespace furnas {

/// How a gas of spheres is drawn.
struct GasOptions {
  double start_fraction = 0.05;  ///< packing fraction of the gas
  std::uint64_t seed = 1;
  double sphere_volume = 0;  ///< of all spheres [d_s^3]; 0: summed up
};

/// A gas of spheres of these radii [d_s], of density 1 and at rest, that do not touch, in a cubic cell. Each
/// is put at a random place, again until it is free (random sequential addition), the biggest first;
/// particles are in the order of their radii, as given. Their species follow their sizes. Throws InputError
/// when no free place is found, when the cell is no wider than the biggest sphere, and for more than 2^31 - 1
/// spheres.
Packing dilute_gas(const std::vector<double>& radii, const GasOptions& options);

}  // namespace furnas
