#pragma once

#include <cstdint>
#include <string>

#include "engine/model.h"
#include "engine/state/packing.h"

namespace furnas {

/// What is wrong with a packing, in a sentence with ids and step; empty if it is sound: its numbers are
/// finite, the spheres fill less than the cell, no two centres nearly coincide, and the time step is stable
/// for the contacts as they are.
std::string fault_of(const Packing& packing, const Model& model);

/// Overlap beyond which two spheres count as having run through each other, as a share of the sum of their
/// radii: their centres nearly coincide, and the normal means nothing any more.
inline constexpr double deepest_overlap = 0.9;

/// Upper bound of the frequency of the particles' springs times the time step; explicit integration of
/// undamped springs is stable below 2. The row sum of M^-1 K bounds its eigenvalues: with rotations in units
/// of 0.4 R a contact adds max(2 k_n, 7 k_t)/m, exact for two equal spheres that stick.
double stiffest_step(const Packing& packing, const Model& model);

/// Compares the contacts of `sample` particles, drawn by `key`, with all others and all their images. Answers
/// a sentence about the first difference; empty if there is none.
std::string audit_contacts(const Packing& packing, std::size_t sample, std::uint64_t key);

}  // namespace furnas
