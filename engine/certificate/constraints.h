#pragma once

#include <cstdint>

#include "engine/certificate/backbone.h"
#include "engine/state/cell.h"

namespace furnas {

/// Maxwell's count: what the contacts hold, and what there is to be held.
struct ConstraintCount {
  std::int64_t constraints{};  ///< force components that the contacts can choose
  std::int64_t needed{};       ///< freedoms of the backbone and its cell, or more in a fixed cell
};

/// A contact without friction holds the distance: 1; one that sticks holds three components: 3; one that
/// slides has its |F_t| given by F_n, but not its direction: 2 (Shundyak, van Hecke, van Saarloos, Phys. Rev.
/// E 75, 010301 (2007)). A particle has 3 freedoms, 6 with friction; the packing as a whole may be anywhere:
/// -3; the cell adds its free strains, and if it has none the contacts must carry their load among
/// themselves: +1.
ConstraintCount count_constraints(const ContactNetwork& network, const Backbone& backbone,
                                  CellFreedom freedom);

}  // namespace furnas
