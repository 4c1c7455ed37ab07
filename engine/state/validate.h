#pragma once

#include <string>

#include "engine/state/packing.h"

namespace furnas {

/// A sentence about the first flaw in the numbers of a packing, which names the particle by its id; empty if
/// there is none. In a packing without flaw there are particles, every array has one number per particle, the
/// cell has a volume and tilts of at most most_tilt, radii and masses are positive, contacts are between
/// existing particles, and every number is finite.
std::string flaw_of(const Packing& packing);

/// Throws InputError with `source`, the name of a file, unless it is empty, and such a sentence if spheres,
/// cell, order, the ends of a contact or its history have a flaw, or if two particles have the same centre,
/// because their contact would have no normal. The other numbers of contacts are not checked, because a step
/// computes them again.
void validate(const Packing& packing, const std::string& source = {});

}  // namespace furnas
