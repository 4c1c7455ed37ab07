#pragma once

#include <string>

#include "engine/state/packing.h"

namespace furnas {

/// A sentence about the first flaw in the numbers of a packing, which names the particle by its id; empty if
/// there is none. In a packing without flaw there are particles, the cell has a volume, radii and masses are
/// positive, contacts are between existing particles, and every number is finite.
std::string flaw_of(const Packing& packing);

/// Throws InputError with such a sentence if spheres or cell have a flaw, or if two particles have the same
/// centre, because their contact would have no normal. The numbers of contacts are not checked, because a
/// step computes them again from the positions.
void validate(const Packing& packing);

}  // namespace furnas
