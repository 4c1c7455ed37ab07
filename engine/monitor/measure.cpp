#include "engine/monitor/measure.h"

#include <algorithm>
#include <cmath>

#include "engine/analysis/rattlers.h"
#include "engine/monitor/energy.h"

namespace furnas {
namespace {

void measure_stress(const Packing& p, Measures& m) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (const Contact& c : p.contacts)
    sum += Eigen::Vector3d(c.branch.x, c.branch.y, c.branch.z) *
           Eigen::RowVector3d(c.force.x, c.force.y, c.force.z);
  for (std::size_t k = 0; k < p.size(); ++k) {
    const Eigen::Vector3d v(p.velocity[k].x, p.velocity[k].y, p.velocity[k].z);
    sum += p.mass[k] * v * v.transpose();
  }
  sum = (0.5 / p.cell.volume()) * (sum + sum.transpose()).eval();
  m.stress = {sum(0, 0), sum(1, 1), sum(2, 2), sum(0, 1), sum(0, 2), sum(1, 2)};
  m.pressure = sum.trace() / 3;
}

void measure_contacts(const Packing& p, Measures& m) {
  std::int64_t sliding = 0;
  for (const Contact& c : p.contacts) {
    m.mean_force += norm(c.force);
    m.largest_overlap = std::max(m.largest_overlap, c.overlap / std::min(p.radius[c.i], p.radius[c.j]));
    sliding += c.sliding;
  }
  m.contacts = static_cast<std::int64_t>(p.contacts.size());
  m.coordination = 2 * static_cast<double>(m.contacts) / static_cast<double>(p.size());
  if (m.contacts == 0) return;
  m.mean_force /= static_cast<double>(m.contacts);
  m.sliding_share = static_cast<double>(sliding) / static_cast<double>(m.contacts);
}

void measure_backbone(const Packing& p, const std::vector<bool>& rattler, Measures& m) {
  double force = 0;
  double energy = 0;
  double count = 0;
  for (std::size_t k = 0; k < p.size(); ++k) {
    const double e = kinetic_energy(p, k);
    m.kinetic_energy += e / static_cast<double>(p.size());
    if (rattler[k]) continue;
    force += norm(p.force[k]);
    energy += e;
    ++count;
  }
  if (count == 0 || m.mean_force == 0) return;
  m.backbone_kinetic_energy = energy / count;
  m.force_imbalance = force / count / m.mean_force;
}

}  // namespace

Measures measure(const Packing& p, int backbone_threshold) {
  Measures m;
  m.step = p.step;
  m.particles = static_cast<std::int64_t>(p.size());
  m.time = p.time;
  m.cell = p.cell;
  m.phi = p.fraction_filled();
  m.backbone_threshold = backbone_threshold;
  measure_stress(p, m);
  measure_contacts(p, m);
  const std::vector<bool> live = live_contacts(p);
  for (int n = 0; n < 3; ++n) {
    const int threshold = n + 2;
    const std::vector<bool> out = rattlers(p, live, threshold);
    m.rattlers[static_cast<std::size_t>(n)] = count_rattlers(p, live, out, threshold);
    if (threshold == backbone_threshold) measure_backbone(p, out, m);
  }
  return m;
}

double unloading_strain(const Packing& p, const AnyLaw& law) {
  double push = 0, stiffness = 0;  // of all contacts, against an isotropic strain
  for (const Contact& c : p.contacts) {
    const double distance = norm(c.branch);
    const ContactStiffness spring = stiffness_of(law, touch_of(p, c));
    push += spring.push * distance;
    stiffness += spring.normal * distance * distance;
  }
  return stiffness > 0 ? push / stiffness : 0;
}

}  // namespace furnas
