#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/state/packing.h"

namespace furnas {

/// The sizes of spheres. Sizes that differ by less than a millionth count as one.
struct Sizes {
  std::size_t count{};           ///< number of different sizes
  double smallest{}, largest{};  ///< diameters [d_s]
};

/// The sizes that these radii [d_s] have.
Sizes sizes_of(const std::vector<double>& radius);

/// The species from the sizes. With two sizes, the spheres of the larger size are `large` and the others
/// `small`. With one size or more than two sizes, all are `large`: there is only one species.
std::vector<Species> species_by_size(const std::vector<double>& radius);

/// The species of spheres that have types, which are any whole numbers. If two types occur, they are the two
/// species: the type with the larger mean size is large; if the mean sizes are equal, the lower type. The
/// sizes decide, as in species_by_size(), if the number of types is not two, or if there are exactly two
/// sizes and a type has both of them.
std::vector<Species> species_by_type(const std::vector<double>& radius,
                                     const std::vector<std::int32_t>& type);

/// Whether spheres of one species differ in size. Then f_s, phi_L and phi_S do not exist.
bool is_polydisperse(const Packing& packing);

/// Whether all spheres are of one species but differ in size.
bool is_one_polydisperse_species(const Packing& packing);

}  // namespace furnas
