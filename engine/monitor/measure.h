#pragma once

#include "engine/laws/any_law.h"
#include "engine/state/measures.h"
#include "engine/state/packing.h"

namespace furnas {

/// Measures what history.csv and the verdict need of the packing alone. `backbone_threshold` is the number of
/// live contacts below which a particle counts as a rattler in the verdict: 4 without friction, 2 with
/// friction.
Measures measure(const Packing& packing, int backbone_threshold);

/// The isotropic strain that would unload every contact on average if all followed it: sum of push times d
/// over sum of stiffness times d^2, with the push and the stiffness of the normal springs without motion and
/// the distance d of the centres; 0 without contacts.
double unloading_strain(const Packing& packing, const AnyLaw& law);

}  // namespace furnas
