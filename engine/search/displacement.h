#pragma once

#include <optional>
#include <vector>

#include "engine/state/pair_list.h"

namespace furnas {

/// Displacements of the particles since the neighbour list was built.
struct ListDisplacement {
  /// Upper bound for each size class, without the affine displacement by the cell, measured in the cell at
  /// the time of the build [d_s].
  std::vector<double> largest;
  bool suspect{};   ///< the bounds no longer prove the list complete, or a check of its width is due: measure
                    ///< the displacements
  bool outdated{};  ///< a contact outside the list is possible, or the list is too wide: build a new one
};

/// Whether certainly every pair that touches is still in the list, and every row still means the image for
/// which it was listed. Two particles that were R_i + R_j + skin apart are now at least (1 - e) (R_i + R_j +
/// skin - u_i - u_j) apart, where u_i and u_j are the largest displacements of their classes and e is the
/// shrinkage of the cell since the build.
bool list_is_complete(const PairList& list, const std::vector<double>& displacement, double shrinkage);

/// The same for any rows that were chosen with this skin in this cell.
bool rows_are_complete(const std::vector<SizeClass>& classes, const Skin& skin, const Triangle& edges,
                       const std::vector<double>& displacement, double shrinkage);

/// 1 - the smallest singular value of F = edges_now edges_then^-1: no distance that deforms with the cell has
/// shrunk by a larger share.
double shrinkage(const Triangle& then, const Triangle& now);

/// An upper bound of `shrinkage` that costs only a few operations.
double shrinkage_bound(const Triangle& then, const Triangle& now);

/// Whether the width of a list is to be checked in this step: at ages of 128, 256, 512, ... steps.
bool is_time_to_ask(const PairList& list, std::int64_t step);

/// Whether the skin of the list is more than twice as wide as the skin that the motion since its build calls
/// for, so that a new list is worthwhile. Without this check a packing at rest would keep the wide list that
/// its earlier motion needed.
bool is_too_wide(const PairList& list, const std::vector<double>& displacement, double shrunk,
                 std::int64_t step, std::optional<double> fixed);

/// The skin for the next list, from the speed of the particles and of the cell's shrinkage since the last
/// build. First the life of the list is chosen that minimizes the cost of building plus the cost of needless
/// pairs; the skin follows from this life.
Skin next_skin(const PairList& list, const std::vector<double>& displacement, double shrunk,
               std::int64_t step, std::optional<double> fixed);

}  // namespace furnas
