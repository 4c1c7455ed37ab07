#pragma once

#include "engine/state/measures.h"
#include "engine/state/packing.h"

namespace furnas {

/// Measures everything that history.csv and the verdict need. `backbone_threshold` is the number of live
/// contacts below which a particle counts as a rattler in the verdict: 4 without friction, 2 with friction.
Measures measure(const Packing& packing, int backbone_threshold);

}  // namespace furnas
