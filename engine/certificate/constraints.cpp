#include "engine/certificate/constraints.h"

#include "engine/certificate/modes.h"

namespace furnas {

ConstraintCount count_constraints(const ContactNetwork& network, const Backbone& backbone,
                                  CellFreedom freedom) {
  ConstraintCount count;
  for (const StaticContact* c : backbone.bonds)
    count.constraints += !network.frictional() ? 1 : c->sliding ? 2 : 3;
  const auto members = static_cast<std::int64_t>(backbone.particles.size());
  const std::int64_t strains = free_strains(freedom).cols();
  count.needed = (network.frictional() ? 6 : 3) * members - 3 + (strains > 0 ? strains : 1);
  return count;
}

}  // namespace furnas
