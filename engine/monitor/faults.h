#pragma once

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

}  // namespace furnas
