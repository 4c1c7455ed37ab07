#pragma once

#include "engine/state/packing.h"

namespace furnas {

/// Throws InputError, naming the particle by its id, unless every number of the packing is finite, radii
/// and masses are positive, the cell has a volume and no two particles share a centre.
void validate(const Packing& packing);

}  // namespace furnas
