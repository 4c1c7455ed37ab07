#include "engine/analysis/coordination.h"

namespace furnas {

double Coordination::mean() const {
  if (particles() == 0) return 0;
  return 2 * static_cast<double>(all_contacts()) / static_cast<double>(particles());
}

double Coordination::of(Species species, Species with) const {
  const std::int64_t count = species == Species::large ? large : small;
  if (count == 0) return 0;
  // In a contact between equals both particles belong to the species.
  const double ends = species == with ? 2 : 1;
  return ends * static_cast<double>(contacts[static_cast<std::size_t>(kind_of(species, with))]) /
         static_cast<double>(count);
}

Coordination coordination(const Packing& p) {
  return coordination(p, std::vector<bool>(p.size(), false), all_contacts(p));
}

Coordination coordination(const Packing& p, const std::vector<bool>& rattler, const Selection& contacts) {
  Coordination found;
  for (std::size_t k = 0; k < p.size(); ++k)
    if (!rattler[k]) ++(p.species[k] == Species::large ? found.large : found.small);
  for (const std::size_t n : contacts) ++found.contacts[static_cast<std::size_t>(kind_of(p, p.contacts[n]))];
  return found;
}

}  // namespace furnas
