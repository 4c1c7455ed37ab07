#pragma once

#include <functional>

#include "engine/compaction.h"
#include "engine/events/at_rest.h"
#include "tests/engine/fake_simulation.h"
#include "tests/engine/support/graph_packing.h"

namespace furnas {

/// How far a made-up packing is from rest.
struct Unrest {
  double stress_error = 0;
  double shear = 0;  ///< P_xy/p_a
  double force_imbalance = 0;
  double kinetic_energy = 0;  ///< per particle of the backbone [k_n d_s^2]
  double rattler_energy = 0;  ///< of the rattler alone [k_n d_s^2]
  double strain = 0;          ///< of the edge along x
  bool contacts = true;
  std::size_t groups = 1;  ///< of five spheres in contact
  std::size_t pairs = 0;   ///< of rattlers that touch with next to no force
};

inline constexpr double story_pressure = 1e-4;

/// Steps of 0.02 t_c: a window of 200 t_c is 10 000 of them.
inline const Rhythm story_rhythm(0.02);

/// Groups of five spheres that all touch, each by a contact along every axis, and a rattler: under the
/// pressure 1e-4, save for what `unrest` says. All numbers that the criteria ask for follow from it directly.
inline Packing almost_resting(const Unrest& unrest) {
  const std::size_t spheres = 5 * unrest.groups;
  Edges edges;
  if (unrest.contacts)
    for (std::uint32_t first = 0; first < spheres; first += 5) {
      const Edges group = clique(5, first);
      for (int axis = 0; axis < 3; ++axis) edges.insert(edges.end(), group.begin(), group.end());
    }
  const std::size_t of_groups = edges.size();
  for (std::size_t k = 0; k < unrest.pairs; ++k) {
    const auto first = static_cast<std::uint32_t>(spheres + 1 + 2 * k);
    edges.emplace_back(first, first + 1);
  }
  Packing p = packing_of_graph(spheres + 1 + 2 * unrest.pairs, edges);
  p.cell.edges.xx *= 1 + unrest.strain;
  const auto groups = static_cast<double>(unrest.groups);
  const double pressure = story_pressure * (1 + unrest.stress_error);
  const double force = pressure * p.cell.volume() / (10 * 0.9 * groups);
  const double along = story_pressure * unrest.shear * p.cell.volume() / (10 * 0.9 * groups);
  for (std::size_t n = 0; n < of_groups; ++n) {
    Contact& c = p.contacts[n];
    const std::size_t axis = n % 30 / 10;
    c.branch = axis == 0   ? Vec3<double>{0.9, 0, 0}
               : axis == 1 ? Vec3<double>{0, 0.9, 0}
                           : Vec3<double>{0, 0, 0.9};
    c.force = (force / 0.9) * c.branch;
    if (axis == 0) c.force.y += along;
    if (axis == 1) c.force.x += along;
  }
  for (std::size_t n = of_groups; n < p.contacts.size(); ++n) {
    p.contacts[n].branch = {0.9, 0, 0};
    p.contacts[n].force = {1e-12 * force, 0, 0};
  }
  double mean_force = 0;
  for (const Contact& c : p.contacts) mean_force += norm(c.force) / static_cast<double>(p.contacts.size());
  for (std::size_t k = 0; k < spheres; ++k) {
    p.force[k] = {0, unrest.force_imbalance * mean_force, 0};
    p.spin[k] = {0, 0, std::sqrt(2 * unrest.kinetic_energy / (0.4 * 0.25))};  // a spin bears no stress
  }
  p.spin[spheres] = {0, 0, std::sqrt(2 * unrest.rattler_energy / (0.4 * 0.25))};
  return p;
}

/// A made-up run, seen by a watch.
class RestingStory {
 public:
  using Tale = std::function<Unrest(std::int64_t step)>;

  explicit RestingStory(const Tale& tale, const RestCriteria& criteria = {})
      : simulation([tale](std::int64_t step) { return almost_resting(tale(step)); }),
        now(simulation, 3),
        watch(criteria, story_rhythm) {
    simulation.model().barostat.pressure = story_pressure;
  }

  /// Looks at each period until the packing rests; gives the step, or -1 if that takes too many looks.
  std::int64_t rests_at(int most_looks = 300) {
    for (int n = 0; n < most_looks; ++n) {
      simulation.advance(watch.period(), nullptr);
      if (watch.look(now).resting) return simulation.step();
    }
    return -1;
  }

  FakeSimulation simulation;
  Observation now;
  RestWatch watch;
};

}  // namespace furnas
