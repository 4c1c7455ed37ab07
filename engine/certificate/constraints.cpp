#include "engine/certificate/constraints.h"

#include <algorithm>
#include <vector>

#include "engine/certificate/modes.h"

namespace furnas {

ConstraintCount count_constraints(const ContactNetwork& network, const Backbone& backbone,
                                  CellFreedom freedom) {
  ConstraintCount count;
  std::vector<int> contacts(backbone.contains.size());
  for (const StaticContact* c : backbone.bonds) {
    ++contacts[c->i], ++contacts[c->j];
    count.constraints += !network.frictional() ? 1 : c->sliding ? 2 : 3;
  }
  const auto members = static_cast<std::int64_t>(backbone.particles.size());
  const std::int64_t strains = free_strains(freedom).cols();
  const auto bridges = network.frictional() ? std::count(contacts.begin(), contacts.end(), 2) : 0;
  count.needed = (network.frictional() ? 6 : 3) * members - 3 + (strains > 0 ? strains : 1) - bridges;
  return count;
}

}  // namespace furnas
