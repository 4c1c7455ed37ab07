#pragma once

#include <cstdint>

#include "engine/certificate/backbone.h"
#include "engine/state/cell.h"

namespace furnas {

/// Maxwell's count: constraints by the contacts, and degrees of freedom.
struct ConstraintCount {
  std::int64_t constraints{};  ///< independent force components of all contacts
  std::int64_t needed{};       ///< degrees of freedom of backbone and cell; one more in a fixed cell
};

/// Constraints: a contact without friction fixes one component, the distance: 1. A sticking contact fixes
/// three components: 3. In a sliding contact F_n determines |F_t| but not its direction: 2 (Shundyak, van
/// Hecke, van Saarloos, Phys. Rev. E 75, 010301 (2007)). Degrees of freedom: 3 per particle, 6 with friction;
/// minus 3 for the translations of the whole packing; with friction minus 1 for the free spin of each bridge
/// (bonds.h); plus the free strains of the cell. A fixed cell has no free strain; then +1, because the
/// contacts need one state of self-stress to carry a load.
ConstraintCount count_constraints(const ContactNetwork& network, const Backbone& backbone,
                                  CellFreedom freedom);

}  // namespace furnas
