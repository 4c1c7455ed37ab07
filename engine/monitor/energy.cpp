#include "engine/monitor/energy.h"

#include "engine/base/sphere.h"

namespace furnas {

Touch<double> touch_of(const Packing& p, const Contact& c) {
  return resting_touch(p.radius[c.i], p.radius[c.j], reduced_mass(p.mass[c.i], p.mass[c.j]), c.overlap);
}

double kinetic_energy(double mass, double radius, const Vec3<double>& velocity, const Vec3<double>& spin) {
  return 0.5 * (mass * dot(velocity, velocity) + sphere_inertia(mass, radius) * dot(spin, spin));
}

double kinetic_energy(const Packing& p, std::size_t k) {
  return kinetic_energy(p.mass[k], p.radius[k], p.velocity[k], p.spin[k]);
}

Energy energy(const Packing& p, const AnyLaw& law) {
  Energy sum;
  for (std::size_t k = 0; k < p.size(); ++k) sum.kinetic += kinetic_energy(p, k);
  for (const Contact& c : p.contacts) {
    const ContactEnergy stored = energy_of(law, touch_of(p, c), c.history);
    sum.normal += stored.normal;
    sum.tangential += stored.tangential;
  }
  return sum;
}

}  // namespace furnas
