#pragma once

#include "engine/state/packing.h"

namespace furnas {

/// Whether a tilt of the cell is larger than this share of the edge to which it is parallel.
bool is_tilted(const Triangle& edges, double farthest);

/// Replaces tilted edges of the cell by the shortest equivalent ones if a tilt exceeds this share of its
/// edge, 1/2 or more. The lattice, and so every contact, force and history, stays the same: only the numbers
/// of the images change, which are integers and therefore exact. Returns whether anything changed.
bool shorten_edges(Packing& packing, double farthest);

}  // namespace furnas
