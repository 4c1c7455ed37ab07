#pragma once

#include <array>
#include <cstdint>

#include "engine/state/cell.h"
#include "engine/state/ledger.h"

namespace furnas {

/// Rattlers of each species at one threshold of contacts.
struct RattlerCount {
  int least_contacts{};     ///< z_min: particles with fewer live contacts are removed repeatedly
  std::int64_t large{};     ///< rattlers among the large spheres
  std::int64_t small{};     ///< rattlers among the small spheres
  std::int64_t backbone{};  ///< particles that remain, N_0
  std::int64_t contacts{};  ///< contacts among those that remain, N_c
  double coordination{};    ///< 2 N_c/N_0; 0 when none remains
};

/// Quantities measured of a packing at one instant.
struct Measures {
  std::int64_t step{};
  std::int64_t particles{};
  double time{};  ///< [time]
  double phi{};   ///< packing fraction
  Cell cell;
  std::array<double, 6> stress{};          ///< P: xx yy zz xy xz yz, contacts and peculiar motion [k_n/d_s]
  double pressure{};                       ///< trace(P)/3 [k_n/d_s]
  double kinetic_energy{};                 ///< per particle, translation and rotation [k_n d_s^2]
  double backbone_kinetic_energy{};        ///< per backbone particle [k_n d_s^2]
  double force_imbalance{};                ///< mean |net force| on the backbone/mean contact force
  double mean_force{};                     ///< mean |contact force| [k_n d_s]
  double largest_overlap{};                ///< largest overlap/smaller radius of its pair
  std::int64_t contacts{};                 ///< all of them, live or not
  double coordination{};                   ///< 2 contacts/N, rattlers included
  double sliding_share{};                  ///< share of the contacts at the Coulomb limit
  std::array<RattlerCount, 3> rattlers{};  ///< z_min 2, 3, 4
  int backbone_threshold{};                ///< the z_min whose backbone is used above
  std::int64_t rebuilds{};  ///< neighbour lists built by this process; in result.json since the run began
  Energy energy;            ///< of the particles, all together
  Ledger ledger;            ///< where the energy came from and went

  /// The count of rattlers whose backbone is used above.
  const RattlerCount& backbone() const {
    return rattlers.at(static_cast<std::size_t>(backbone_threshold - 2));
  }
};

}  // namespace furnas
