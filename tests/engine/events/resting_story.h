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
};

inline constexpr double story_pressure = 1e-4;

/// Steps of 0.02 t_c: a window of 200 t_c is 10 000 of them.
inline const Rhythm story_rhythm(0.02);

/// Five spheres that all touch, each by a contact along every axis, and a rattler: under the pressure
/// 1e-4, save for what `unrest` says. All numbers that the criteria ask for follow from it directly.
inline Packing almost_resting(const Unrest& unrest) {
  Packing p = packing_of_graph(6, unrest.contacts ? clique(5) + clique(5) + clique(5) : Edges{});
  p.cell.edges.xx *= 1 + unrest.strain;
  const double pressure = story_pressure * (1 + unrest.stress_error);
  const double force = pressure * p.cell.volume() / (10 * 0.9);
  const double along = story_pressure * unrest.shear * p.cell.volume() / (10 * 0.9);
  for (std::size_t n = 0; n < p.contacts.size(); ++n) {
    Contact& c = p.contacts[n];
    c.branch = n < 10 ? Vec3<double>{0.9, 0, 0} : n < 20 ? Vec3<double>{0, 0.9, 0} : Vec3<double>{0, 0, 0.9};
    c.force = (force / 0.9) * c.branch;
    if (n < 10) c.force.y += along;
    if (n >= 10 && n < 20) c.force.x += along;
  }
  double mean_force = 0;
  for (const Contact& c : p.contacts) mean_force += norm(c.force) / static_cast<double>(p.contacts.size());
  for (std::size_t k = 0; k < 5; ++k) {
    p.force[k] = {0, unrest.force_imbalance * mean_force, 0};
    p.spin[k] = {0, 0, std::sqrt(2 * unrest.kinetic_energy / (0.4 * 0.25))};  // a spin bears no stress
  }
  p.spin[5] = {0, 0, std::sqrt(2 * unrest.rattler_energy / (0.4 * 0.25))};
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
