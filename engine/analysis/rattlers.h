#pragma once

#include <vector>

#include "engine/state/measures.h"
#include "engine/state/packing.h"

namespace furnas {

/// Normal force below which a contact does not count, as a share of the mean of its kind (large-large,
/// large-small, small-small).
inline constexpr double live_force_share = 0.01;

/// Which contacts are live: their normal force exceeds `share` of the mean normal force of their kind.
std::vector<bool> live_contacts(const Packing& packing, double share = live_force_share);

/// Which particles are rattlers: particles with fewer than `least_contacts` live contacts are removed
/// together with their contacts, and this is repeated until no particle is removed. The remaining particles
/// are the backbone.
std::vector<bool> rattlers(const Packing& packing, const std::vector<bool>& live, int least_contacts);

/// Rattlers per species, and the contacts of the backbone.
RattlerCount count_rattlers(const Packing& packing, const std::vector<bool>& live,
                            const std::vector<bool>& rattler, int least_contacts);

/// The count of rattlers for one force threshold, to show how the count depends on the threshold.
struct RattlerSensitivity {
  double share;  ///< a live contact exceeds this share of the mean normal force of its kind
  RattlerCount count;
};

/// The counts for z_min 2, 3 and 4, each with all of `shares`.
std::vector<RattlerSensitivity> rattler_sensitivity(const Packing& packing,
                                                    const std::vector<double>& shares);

}  // namespace furnas
