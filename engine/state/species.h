#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/state/packing.h"

namespace furnas {

/// Which sizes spheres have. Two that differ by less than a millionth are one.
struct Sizes {
  std::size_t count{};           ///< different ones
  double smallest{}, largest{};  ///< diameters [d_s]
};
Sizes sizes_of(const std::vector<double>& radius);

/// Spheres of two sizes: the larger ones are large, the others small. Spheres of one size, and of more than
/// two, are all `large`: they have no two species.
std::vector<Species> species_by_size(const std::vector<double>& radius);

/// The same where each sphere has a type, any whole number. If two types occur, they are the two species: the
/// type of the larger mean size is large; of equal ones, the lower type. Only where there are two sizes and a
/// type has both of them, sizes decide.
std::vector<Species> species_by_type(const std::vector<double>& radius,
                                     const std::vector<std::int32_t>& type);

/// Whether spheres of one species differ in size. Then f_s, phi_L and phi_S do not exist.
bool is_polydisperse(const Packing& packing);

/// Whether spheres differ in size and are all of one species: there is nothing to tell apart but sizes.
bool is_one_polydisperse_species(const Packing& packing);

}  // namespace furnas
