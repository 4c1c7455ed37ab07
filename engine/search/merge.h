#pragma once

#include <vector>

#include "engine/base/vec3.h"
#include "engine/state/pair_list.h"

namespace furnas {

/// Cells between the nearest image of the partner and the one that row `k` of particle `i` means.
std::array<std::int8_t, 3> image_of_row(const PairList& list, std::uint64_t k, const Fraction& i,
                                        const Fraction& j);

/// The image of a contact of i and j as seen from j.
std::array<std::int8_t, 3> image_seen_from_j(const std::array<std::int8_t, 3>& image, const Fraction& i,
                                             const Fraction& j);

/// The tangential history of the rows of `fresh`, taken from the rows of `old` that mean the same image
/// of the same pair; zero for new pairs. Both lists are about particles at `positions`.
std::vector<Vec3<double>> merged_history(const PairList& old, const std::vector<Vec3<double>>& old_history,
                                         const PairList& fresh, const std::vector<Fraction>& positions);

}  // namespace furnas
