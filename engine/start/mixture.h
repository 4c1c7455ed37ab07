#pragma once

#include <cstdint>

#include "engine/state/packing.h"

namespace furnas {

/// Two sizes of spheres of density 1; the small ones have the diameter 1.
struct Mixture {
  double size_ratio = 1;         ///< alpha, diameter of the large ones [d_s]; 1 if there is no small one
  double small_fraction = 0;     ///< f_s, share of the small spheres in the volume of all spheres
  std::int64_t large = 1000;     ///< N_l
  double start_fraction = 0.05;  ///< packing fraction of the gas
  std::uint64_t seed = 1;
};

/// N_s = N_l alpha^3 f_s/(1 - f_s), rounded to a whole number. The type is double, so that it cannot
/// overflow.
double small_count(const Mixture& mixture);

/// Diameter of the large spheres [d_s]: size_ratio, or 1 if there are no small spheres, because then the
/// large spheres are the smallest.
double large_diameter(const Mixture& mixture);

/// A gas of these spheres (dilute_gas in engine/start/gas.h); large ones first. Throws InputError if there is
/// no large sphere, if the size ratio is below 1, and as dilute_gas.
Packing dilute_start(const Mixture& mixture);

/// Gives each sphere the mass (pi/6) d^exponent [rho d_s^3], where d is its diameter in units of d_s. Statics
/// does not depend on the masses, and lighter large spheres come to rest sooner.
void set_masses(Packing& packing, double exponent);

}  // namespace furnas
