#pragma once

#include <vector>

#include "engine/search/grid.h"
#include "engine/state/pair_list.h"

namespace furnas {

/// A grid for each size class; its bins are as wide as the sum of two radii of the class plus skin. Uses the
/// memory of `former` grids.
std::vector<Grid> bin_classes(const std::vector<SizeClass>& classes, const Skin& skin, const Triangle& edges,
                              const std::vector<Fraction>& positions, std::vector<Grid> former = {});

/// Lists every pair whose surfaces are closer than the skin; each image of a pair gets its own row. Fills
/// `first`, `partner`, `quarter`, `incoming` and `edges` of `list` from its classes, skin and reference
/// positions; what these held before does not matter.
/// Partners of the same class are searched in the bins around a sphere. Partners of a smaller class are
/// searched from the larger sphere, in the bins of their grid that lie within its reach.
void find_pairs(const std::vector<Grid>& grids, const Triangle& edges, const std::vector<double>& radii,
                PairList& list);

/// Computes `incoming_first` and `incoming` from the rows.
void index_incoming(PairList& list);

}  // namespace furnas
