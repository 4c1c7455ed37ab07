#pragma once

#include <optional>
#include <vector>

#include "engine/state/pair_list.h"

namespace furnas {

/// How far the packing has moved since the list was built.
struct Wear {
  std::vector<double> travelled;  ///< no particle of the class has moved further, the affine part apart [d_s]
  bool suspect{};                 ///< the bounds above no longer prove the list complete: measure
  bool worn{};                    ///< a contact outside the list is possible: build a new one
};

/// Whether every pair that touches must still be in the list: for each pair of classes,
/// u_i + u_j + e (R_i + R_j + skin) <= skin, e = 1 - (smallest stretch of the cell since the build).
bool list_is_complete(const PairList& list, const std::vector<double>& travelled, double shrinkage);

/// 1 - the smallest singular value of F = edges_now edges_then^-1: no distance that moves with the cell
/// has shrunk by a larger share.
double shrinkage(const Triangle& now, const Triangle& then);

/// A bound of `shrinkage` that costs a few operations.
double shrinkage_bound(const Triangle& now, const Triangle& then);

/// The skin for the next list, from how fast particles moved and the cell shrank under the last one: the
/// life that makes building and needless pairs together cheapest, and the room needed to live so long.
Skin next_skin(const PairList& list, const std::vector<double>& travelled, double shrunk, std::int64_t step,
               std::optional<double> fixed);

}  // namespace furnas
