#include "engine/analysis/energy.h"

#include "engine/base/sphere.h"

namespace furnas {

double kinetic_energy(const Packing& p, std::size_t k) {
  return 0.5 * (p.mass[k] * dot(p.velocity[k], p.velocity[k]) +
                sphere_inertia(p.mass[k], p.radius[k]) * dot(p.spin[k], p.spin[k]));
}

Energy energy(const Packing& p, const AnyLaw& law) {
  const HookeConstants& springs =
      std::visit([](const auto& l) -> const HookeConstants& { return l.constants; }, law);
  Energy sum;
  for (std::size_t k = 0; k < p.size(); ++k) sum.kinetic += kinetic_energy(p, k);
  for (const Contact& c : p.contacts) {
    sum.normal += normal_energy(c.overlap);
    sum.tangential += tangential_energy(springs, c.history);
  }
  return sum;
}

}  // namespace furnas
