#pragma once

#include <array>
#include <cstdint>
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

/// A contact on its way from one list to the next.
template <class Real>
struct CarriedContact {
  std::uint32_t i, j;                ///< particles, as in PairList
  std::array<std::int8_t, 3> image;  ///< as in image_of_row()
  Vec3<Real> history;                ///< as in Spring; zero without friction
};

/// Contacts in the order of their rows, those of each 1024 particles apart.
template <class Real>
using CarriedContacts = std::vector<std::vector<CarriedContact<Real>>>;

/// The contacts that touched in the last step. Their rows can then be overwritten. The particles are now at
/// `positions`.
template <class Real>
CarriedContacts<Real> contacts_of_rows(const PairList& list, const ContactState<Real>& contact_state,
                                       const std::vector<Fraction>& positions);

/// Gives each carried contact the row of `list` with the same image of the same pair; all other rows have
/// never touched. A contact that is not in the list is lost. `friction`: the rows have springs.
template <class Real>
void enter_contacts(const CarriedContacts<Real>& carried, const PairList& list,
                    const std::vector<Fraction>& positions, bool friction, ContactState<Real>& contact_state);

}  // namespace furnas
