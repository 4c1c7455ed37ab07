#pragma once

#include <rapidcheck.h>

#include <array>
#include <map>
#include <vector>

#include "engine/simulation.h"
#include "tests/engine/support/brute_force.h"

/// The engine's contacts, forces and stress against all pairs and all images, inside a RapidCheck property.
namespace furnas::test {

inline bool near(const Vec3<double>& a, const Far& b, Long scale) {
  return norm(Far{a.x - b.x, a.y - b.y, a.z - b.z}) <= Long(1e-13) * scale;
}

/// Sums of the brute force over the contacts, and how large their terms are.
struct Sums {
  explicit Sums(std::size_t n) : force(n), torque(n), scale(n) {}

  void add(const Packing& p, const TouchName& name, const BruteTouch& touch, const Far& f, Long size) {
    const Long half_overlap = (Long(p.radius[name.i]) + Long(p.radius[name.j]) - touch.distance) / 2;
    const Far couple = cross(touch.branch * (1 / touch.distance), f);
    force[name.i] += f;
    force[name.j] -= f;
    torque[name.i] -= (Long(p.radius[name.i]) - half_overlap) * couple;
    torque[name.j] -= (Long(p.radius[name.j]) - half_overlap) * couple;
    scale[name.i] += size;
    scale[name.j] += size;
    stress[0] += touch.branch.x * f, stress[1] += touch.branch.y * f, stress[2] += touch.branch.z * f;
    stress_scale += touch.distance * size;
  }

  std::vector<Far> force, torque;
  std::array<Far, 3> stress{};
  std::vector<Long> scale;
  Long stress_scale{};
};

inline void compare_with_brute_force(const Model& model, const Packing& start) {
  const Packing p = make_simulation(model, start)->packing();
  const bool spins = std::holds_alternative<HookeSynchronized>(model.law);
  const HookeConstants law = spins ? std::get<HookeSynchronized>(model.law).constants
                                   : std::get<Frictionless<false>>(model.law).constants;

  const auto expected = brute_pairs(p, 0);
  std::map<TouchName, Contact> found;
  for (const Contact& c : p.contacts) RC_ASSERT(found.emplace(name_of(p, c), c).second);

  Sums sums(p.size());
  for (const auto& [name, touch] : expected) {
    const Long reach = Long(p.radius[name.i]) + Long(p.radius[name.j]);
    const Far f = brute_force(p, law, spins, name, touch);
    if (!found.contains(name)) {
      RC_ASSERT(reach - touch.distance <= 1e-14L * reach);  // touch of points, open to rounding
      continue;
    }
    const Contact c = found.at(name);
    found.erase(name);
    const bool same_way =
        c.i == name.i && c.image == std::array<std::int8_t, 3>{static_cast<std::int8_t>(name.image[0]),
                                                               static_cast<std::int8_t>(name.image[1]),
                                                               static_cast<std::int8_t>(name.image[2])};
    const double sign = same_way ? 1 : -1;
    // An overlap is a difference of lengths: it is known to the rounding of those.
    const Long size = norm(f) + reach;
    RC_ASSERT(near(sign * c.branch, touch.branch, reach));
    RC_ASSERT(std::abs(c.overlap - (reach - touch.distance)) <= 1e-13L * reach);
    RC_ASSERT(near(sign * c.force, f, size));
    sums.add(p, name, touch, f, size);
  }
  for (const auto& [name, c] : found) RC_ASSERT(c.overlap <= 1e-14 * (p.radius[c.i] + p.radius[c.j]));
  for (std::size_t k = 0; k < p.size(); ++k) {
    RC_ASSERT(near(p.force[k], sums.force[k], sums.scale[k]));
    RC_ASSERT(near(p.torque[k], spins ? sums.torque[k] : Far{}, p.radius[k] * sums.scale[k]));
  }
  for (int a = 0; a < 3; ++a) {
    const Vec3<double> row{p.stress.contacts(a, 0), p.stress.contacts(a, 1), p.stress.contacts(a, 2)};
    RC_ASSERT(near(row, sums.stress[static_cast<std::size_t>(a)], sums.stress_scale));
  }
}

}  // namespace furnas::test
