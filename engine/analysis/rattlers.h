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

/// Which particles are rattlers: those with fewer than `least_contacts` live contacts are taken out
/// with their contacts, again and again until none goes; what remains is the backbone.
std::vector<bool> rattlers(const Packing& packing, const std::vector<bool>& live, int least_contacts);

/// Rattlers per species, and the contacts of the backbone.
RattlerCount count_rattlers(const Packing& packing, const std::vector<bool>& live,
                            const std::vector<bool>& rattler, int least_contacts);

/// What the count of rattlers owes to the force below which a contact does not count.
struct RattlerSensitivity {
  double share;  ///< of the mean normal force of its kind that a live contact exceeds
  RattlerCount count;
};

/// The counts for z_min 2, 3 and 4, each with all of `shares`.
std::vector<RattlerSensitivity> rattler_sensitivity(const Packing& packing,
                                                    const std::vector<double>& shares);

}  // namespace furnas
