#pragma once

#include <string>

#include "engine/state/packing.h"

namespace furnas {

/// What is wrong with the numbers of a packing, in a sentence that names the particle by its id; empty if it
/// is sound: there are particles, the cell has a volume, radii and masses are above zero, contacts are of
/// particles that exist, and every number is finite.
std::string flaw_of(const Packing& packing);

/// Throws InputError with the sentence of flaw_of(), and when two particles share a centre, where no contact
/// has a normal.
void validate(const Packing& packing);

}  // namespace furnas
