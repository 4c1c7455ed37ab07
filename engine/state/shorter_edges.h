#pragma once

#include "engine/state/packing.h"

namespace furnas {

/// Largest tilt of a cell, as a share of the edge to which the tilt is parallel; beyond it the images of
/// particles cannot be counted.
inline constexpr double most_tilt = 1e6;

/// Whether a tilt of the cell is larger than this share of the edge to which it is parallel.
bool is_tilted(const Triangle& edges, double farthest);

/// Replaces tilted edges of the cell by the shortest equivalent ones if a tilt exceeds this share of its
/// edge, 1/2 or more; no tilt may exceed most_tilt. The lattice, and so every contact, force and history,
/// stays the same: only the numbers of the images change, which are integers and therefore exact. Returns
/// whether anything changed.
bool shorten_edges(Packing& packing, double farthest);

}  // namespace furnas
