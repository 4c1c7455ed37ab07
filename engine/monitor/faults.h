#pragma once

#include <string>

#include "engine/model.h"
#include "engine/state/packing.h"

namespace furnas {

/// A sentence, with the ids of particles and the step, about the first fault of a packing; empty if there
/// is none. In a packing without fault all numbers are finite, the volume of the spheres is below that of the
/// cell, no two centres nearly coincide, and the time step is stable for the present contacts.
std::string fault_of(const Packing& packing, const Model& model);

/// Largest allowed overlap, as a share of the sum of the radii. Beyond it the centres nearly coincide, and
/// the normal has no meaning.
inline constexpr double deepest_overlap = 0.9;

}  // namespace furnas
