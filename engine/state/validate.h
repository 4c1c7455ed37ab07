#pragma once

#include <string>

#include "engine/state/packing.h"

namespace furnas {

/// What is wrong with the numbers of a packing, in a sentence that names the particle by its id; empty if it
/// is sound: there are particles, the cell has a volume, radii and masses are above zero, contacts are of
/// particles that exist, and every number is finite.
std::string flaw_of(const Packing& packing);

/// Throws InputError with such a sentence about spheres and cell, and when two particles share a centre,
/// where no contact has a normal. Numbers of contacts are not asked for: a step works them out anew from the
/// positions.
void validate(const Packing& packing);

}  // namespace furnas
