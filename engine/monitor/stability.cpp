#include "engine/monitor/stability.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "engine/monitor/energy.h"

namespace furnas {
namespace {

/// The step at which K dt^2 + 2 C dt = 4.
double stable_step(double stiffness, double damping) {
  return 4 / (damping + std::sqrt(damping * damping + 4 * stiffness));
}

/// The least of the stable steps along the normals and across them. `weight` is that of the damping.
double stable_step_of(const AnyLaw& law, const Touch<double>& pair, int contacts, double weight) {
  const ContactStiffness s = stiffness_of(law, pair);
  const double normal =
      stable_step(contacts * s.normal / pair.reduced_mass, weight * contacts * s.normal_damping);
  if (!has_friction(law)) return normal;
  // For slip of two spheres the inverse mass is 7/2 of 1/m_eff, because the spheres also rotate.
  const double each = 3.5 * contacts;
  return std::min(normal,
                  stable_step(each * s.tangential / pair.reduced_mass, weight * each * s.tangential_damping));
}

}  // namespace

std::optional<double> collision_time(const AnyLaw& law, const Touch<double>& pair) {
  const ContactStiffness s = stiffness_of(law, pair);
  const double squared = s.normal / pair.reduced_mass - s.normal_damping * s.normal_damping / 4;
  if (!(squared > 0)) return {};
  return std::numbers::pi / std::sqrt(squared);
}

double restitution(const AnyLaw& law, const Touch<double>& pair) {
  const auto time = collision_time(law, pair);
  return time ? std::exp(-0.5 * stiffness_of(law, pair).normal_damping * *time) : 0;
}

double pair_frequency(const AnyLaw& law, const Touch<double>& pair) {
  return std::sqrt(stiffness_of(law, pair).stiffest() / pair.reduced_mass);
}

double largest_stable_step(const AnyLaw& law, const Touch<double>& pair, int contacts) {
  return stable_step_of(law, pair, contacts, is_synchronized(law) ? 2 : 1);
}

double largest_stable_step_of_midway(const AnyLaw& law, const Touch<double>& pair, int contacts) {
  return stable_step_of(law, pair, contacts, 1);
}

double stiffest_step(const Packing& p, const Model& model) {
  std::vector<double> held(p.size());
  for (const Contact& c : p.contacts) {
    const double stiffness = 2 * stiffness_of(model.law, touch_of(p, c)).stiffest();
    held[c.i] += stiffness, held[c.j] += stiffness;
  }
  double square = 0;
  for (std::size_t k = 0; k < p.size(); ++k) square = std::max(square, held[k] / p.mass[k]);
  return model.time_step * std::sqrt(square);
}

}  // namespace furnas
