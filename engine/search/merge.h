#pragma once

#include <vector>

#include "engine/base/vec3.h"
#include "engine/state/pair_list.h"
#include "engine/state/state.h"

namespace furnas {

/// Cells between the nearest image of the partner and the one that row `k` of particle `i` means.
std::array<std::int8_t, 3> image_of_row(const PairList& list, std::uint64_t k, const Fraction& i,
                                        const Fraction& j);

/// The image of a contact of i and j as seen from j.
std::array<std::int8_t, 3> image_seen_from_j(const std::array<std::int8_t, 3>& image, const Fraction& i,
                                             const Fraction& j);

/// Carries the contact state of the pairs of `old` over to those of `fresh` that mean the same image of the
/// same pair; that of other pairs is lost, and new pairs have none. Both lists are about particles at
/// `positions`.
template <class Real>
void merge_contact_state(const PairList& old, ContactState<Real>& contact_state, const PairList& fresh,
                         const std::vector<Fraction>& positions, bool friction);

}  // namespace furnas
