#include "engine/events/quench.h"

#include <algorithm>

#include "engine/analysis/energy.h"

namespace furnas {

bool Quench::due(Observation& now) {
  constexpr double nearly = 100;  // times the limits; the stress, which the cell follows at once, 10 times
  constexpr std::int64_t patience = 50;
  const RestReport& r = watch_.look(now);
  const RestCriteria& c = watch_.criteria();
  const bool slow =
      r.backbone > 0 && r.stress_error < 10 * c.stress_error && r.kinetic_energy < nearly * c.kinetic_energy;
  slow_windows_ = slow ? slow_windows_ + 1 : std::max<std::int64_t>(slow_windows_ - 1, 0);
  const bool near =
      r.force_imbalance < nearly * c.force_imbalance && r.strain_drift < nearly * c.strain_drift;
  return slow && (near || slow_windows_ > patience);
}

std::string Quench::memory() { return std::to_string(count_) + ' ' + std::to_string(slow_windows_); }

void Quench::recall(const std::string& memory) {
  const auto space = memory.find(' ');
  count_ = recalled_count(memory.substr(0, space));
  slow_windows_ = recalled_count(space == std::string::npos ? "" : memory.substr(space + 1));
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
