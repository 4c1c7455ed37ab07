#include "engine/events/still_rattlers.h"

#include "engine/analysis/energy.h"
#include "engine/analysis/rattlers.h"

namespace furnas {

bool StillRattlers::due(Observation& now) {
  constexpr double nearly = 100;  // times the limits of balance and drift
  const RestReport& r = watch_.look(now);
  const RestCriteria& c = watch_.criteria();
  return r.backbone > 0 && r.stress_error < c.stress_error && r.kinetic_energy < c.kinetic_energy &&
         r.force_imbalance < nearly * c.force_imbalance && r.strain_drift < nearly * c.strain_drift;
}

std::optional<Verdict> StillRattlers::fire(Observation& now) {
  Packing packing = now.packing();
  const std::vector<bool> out = rattlers(packing, live_contacts(packing), now.measures().backbone_threshold);
  for (std::size_t k = 0; k < packing.size(); ++k) {
    if (!out[k]) continue;
    packing.ledger.stilled += kinetic_energy(packing, k);
    packing.velocity[k] = packing.spin[k] = {};
  }
  now.replace(packing);
  ++count_;
  return {};
}

}  // namespace furnas
