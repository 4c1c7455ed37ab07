#include "engine/trials/balls.h"

#include <cmath>

#include "engine/simulation.h"

namespace furnas {

Packing packing_of(const Triangle& edges, const std::vector<Ball>& balls) {
  Packing p;
  p.cell.edges = edges;
  p.resize(balls.size());
  for (std::size_t k = 0; k < balls.size(); ++k) {
    p.radius[k] = balls[k].radius;
    p.mass[k] = mass_of(balls[k].radius);
    p.species[k] = balls[k].radius > 0.5 ? Species::large : Species::small;
    p.fraction[k] = to_fraction(inverse(edges) * balls[k].position);
    p.velocity[k] = balls[k].velocity;
    p.spin[k] = balls[k].spin;
  }
  return p;
}

Packing after(const Model& model, const Packing& start, std::int64_t steps) {
  const auto simulation = make_simulation(model, start);
  simulation->advance(steps);
  return simulation->packing();
}

double inertia_of_cell(const Packing& p) {
  const double length = std::cbrt(p.sphere_volume() / 0.64);
  return p.sphere_volume() * length * length / 12;
}

double kinetic_energy(const Packing& p) {
  double sum = 0;
  for (std::size_t k = 0; k < p.size(); ++k)
    sum += 0.5 * p.mass[k] * dot(p.velocity[k], p.velocity[k]) +
           0.2 * p.mass[k] * p.radius[k] * p.radius[k] * dot(p.spin[k], p.spin[k]);
  return sum;
}

double elastic_energy(const Packing& p, double tangential_stiffness) {
  double sum = 0;
  for (const Contact& c : p.contacts)
    sum += 0.5 * (c.overlap * c.overlap + tangential_stiffness * dot(c.history, c.history));
  return sum;
}

Vec3<double> momentum(const Packing& p) {
  Vec3<double> sum;
  for (std::size_t k = 0; k < p.size(); ++k) sum += p.mass[k] * p.velocity[k];
  return sum;
}

double kept_enthalpy(const Packing& p, const Barostat& bath) {
  const Triangle& e = p.cell.rate;
  return kinetic_energy(p) + elastic_energy(p) + bath.pressure * p.cell.volume() +
         0.5 * bath.inertia * contraction(e, e);
}

}  // namespace furnas
