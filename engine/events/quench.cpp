#include "engine/events/quench.h"

#include "engine/analysis/energy.h"

namespace furnas {

bool Quench::due(Observation& now) {
  constexpr double nearly = 100;  // times the limits; the stress, which the cell follows at once, 10 times
  const RestReport& r = watch_.look(now);
  const RestCriteria& c = watch_.criteria();
  return r.backbone > 0 && r.stress_error < 10 * c.stress_error &&
         r.kinetic_energy < nearly * c.kinetic_energy && r.force_imbalance < nearly * c.force_imbalance &&
         r.strain_drift < nearly * c.strain_drift;
}

std::optional<Verdict> Quench::fire(Observation& now) {
  Packing packing = now.packing();
  for (std::size_t k = 0; k < packing.size(); ++k) {
    packing.ledger.quenched += kinetic_energy(packing, k);
    packing.velocity[k] = packing.spin[k] = {};
  }
  packing.cell.rate = {};
  now.replace(packing);
  ++count_;
  return {};
}

}  // namespace furnas
