#pragma once

#include <vector>

#include "engine/base/vec3.h"
#include "engine/state/pair_list.h"
#include "engine/state/state.h"

namespace furnas {

/// Number of cells, along each edge, between the nearest image of the partner and the image that row `k` of
/// particle `i` means.
std::array<std::int8_t, 3> image_of_row(const PairList& list, std::uint64_t k, const Fraction& i,
                                        const Fraction& j);

/// The image of a contact of i and j as seen from j.
std::array<std::int8_t, 3> image_seen_from_j(const std::array<std::int8_t, 3>& image, const Fraction& i,
                                             const Fraction& j);

/// Copies the contact state from each row of `old` to the row of `fresh` with the same image of the same
/// pair. The state of pairs that are not in `fresh` is lost; new pairs start without a state. Both lists have
/// the same particles, which are now at `positions`.
template <class Real>
void merge_contact_state(const PairList& old, ContactState<Real>& contact_state, const PairList& fresh,
                         const std::vector<Fraction>& positions, bool friction);

}  // namespace furnas
