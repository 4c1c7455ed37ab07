#pragma once

#include <vector>

#include "engine/search/grid.h"
#include "engine/state/pair_list.h"

namespace furnas {

/// A grid of each size class, for contacts of two of its spheres with the skin.
std::vector<Grid> bin_classes(const std::vector<SizeClass>& classes, const Skin& skin, const Triangle& edges,
                              const std::vector<Fraction>& positions);

/// Lists every pair, each image of it apart, whose surfaces are closer than the skin: fills `first`,
/// `partner`, `quarter` and `edges` of `list` from its classes, skin and reference positions. A sphere looks
/// for equals in the bins around it; a larger one looks for smaller ones in the bins of their grid that its
/// ball touches.
void find_pairs(const std::vector<Grid>& grids, const Triangle& edges, const std::vector<double>& radii,
                PairList& list);

/// Fills `incoming_first` and `incoming` from the rows.
void index_incoming(PairList& list);

}  // namespace furnas
