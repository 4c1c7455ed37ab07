#pragma once

#include <vector>

#include "engine/search/bins.h"
#include "engine/state/pair_list.h"

namespace furnas {

/// Bins of each size class, each as wide as the contact of two of its spheres with the skin.
std::vector<Bins> bin_classes(const std::vector<SizeClass>& classes, const Skin& skin, const Triangle& edges,
                              const std::vector<Fraction>& positions);

/// Lists every pair, each image of it apart, whose surfaces are closer than the skin: fills `first`,
/// `partner`, `quarter` and the build record of `list` from its classes and skin. A sphere looks for
/// equals on the grid of its own class and for larger ones on theirs; never for smaller ones, which
/// look for it.
void find_pairs(const std::vector<Bins>& bins, const Triangle& edges, const std::vector<Fraction>& positions,
                const std::vector<double>& radii, PairList& list);

/// Fills `incoming_first` and `incoming` from the rows.
void index_incoming(PairList& list);

}  // namespace furnas
