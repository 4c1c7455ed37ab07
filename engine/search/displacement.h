#pragma once

#include <optional>
#include <vector>

#include "engine/state/pair_list.h"

namespace furnas {

/// How far the particles have moved since the neighbour list was built.
struct ListDisplacement {
  /// Upper bound for each size class: without the cell's affine part, in the cell of the list [d_s].
  std::vector<double> largest;
  bool suspect{};   ///< the bounds above no longer prove the list complete, or it is time to ask: measure
  bool outdated{};  ///< a contact outside the list is possible, or it is too wide: build a new one
};

/// Whether every pair that touches must still be in the list, and every row still mean the image it was
/// listed for. For each pair of classes, two that were R_i + R_j + skin apart are now at least
/// (1 - e) (R_i + R_j + skin - u_i - u_j) apart, with e the shrinkage of the cell since the build.
bool list_is_complete(const PairList& list, const std::vector<double>& displacement, double shrinkage);

/// The same of any rows that were chosen by this skin in this cell.
bool rows_are_complete(const std::vector<SizeClass>& classes, const Skin& skin, const Triangle& edges,
                       const std::vector<double>& displacement, double shrinkage);

/// 1 - the smallest singular value of F = edges_now edges_then^-1: no distance that moves with the cell
/// has shrunk by a larger share.
double shrinkage(const Triangle& now, const Triangle& then);

/// A bound of `shrinkage` that costs a few operations.
double shrinkage_bound(const Triangle& now, const Triangle& then);

/// Whether a list is to be asked for its width in this step: at ages of 128, 256, 512, ... steps.
bool is_time_to_ask(const PairList& list, std::int64_t step);

/// Whether the list is so much wider than what the packing has needed under it that a new one pays. A packing
/// that comes to rest would otherwise keep the needless pairs of its motion for good.
bool is_too_wide(const PairList& list, const std::vector<double>& displacement, double shrunk,
                 std::int64_t step, std::optional<double> fixed);

/// The skin for the next list, from how fast particles moved and the cell shrank under the last one: the
/// life that makes building and needless pairs together cheapest, and the room needed to live so long.
Skin next_skin(const PairList& list, const std::vector<double>& displacement, double shrunk,
               std::int64_t step, std::optional<double> fixed);

}  // namespace furnas
