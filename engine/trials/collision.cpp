#include "engine/trials/collision.h"

#include "engine/simulation.h"

namespace furnas {

Bounce bounce(const Model& model, Ball i, Ball j, double phase, int most_steps) {
  const double length = 256;
  const double gap = (j.velocity.x - i.velocity.x) * model.time_step * (1 + phase);
  j.position = {length / 2, length / 2, length / 2};
  i.position = j.position + Vec3<double>{i.radius + j.radius + gap, 0, 0};
  const auto simulation = make_simulation(model, packing_of(cube(length), {i, j}));

  Bounce b;
  for (int step = 0; step < most_steps; ++step) {
    simulation->advance(1);
    b.end = simulation->packing();
    if (b.end.contacts.empty() && b.steps > 0) break;
    if (b.end.contacts.empty()) continue;
    ++b.steps;
    if (b.end.contacts[0].overlap > b.largest_overlap) {
      b.largest_overlap = b.end.contacts[0].overlap;
      b.step_of_largest = b.steps;
    }
  }
  b.approach = b.end.velocity[0] - b.end.velocity[1];
  return b;
}

std::vector<EntryPhase> phases_of_a_collision(double duration, double step) {
  constexpr int generator = 78;
  std::vector<EntryPhase> phases;
  for (int n = 0; n < phase_count; ++n) {
    const double exit = static_cast<double>(n * generator % phase_count) / phase_count;
    phases.push_back({duration / (duration / step + exit), (n + 0.5) / phase_count});
  }
  return phases;
}

std::vector<Rebound> rebounds(const Model& model, double normal_speed, double tangential_speed,
                              double radius_i, double radius_j) {
  const double damping = constants_of(model.law).normal_damping;
  const double duration = HeadOn{damping, reduced_mass_of(radius_i, radius_j)}.duration();
  std::vector<Rebound> all;
  for (const EntryPhase& phase : phases_of_a_collision(duration, model.time_step)) {
    Model near = model;
    near.time_step = phase.time_step;
    const Bounce b = bounce(near, {.velocity = {-normal_speed, tangential_speed, 0}, .radius = radius_i},
                            {.radius = radius_j}, phase.entry);
    const Packing& p = b.end;
    all.push_back({b.approach.x, b.approach.y - radius_i * p.spin[0].z - radius_j * p.spin[1].z, p.spin[0].z,
                   p.spin[1].z});
  }
  return all;
}

Rebound mean_of(const std::vector<Rebound>& rebounds) {
  Rebound mean;
  for (const Rebound& r : rebounds) {
    const auto n = static_cast<double>(rebounds.size());
    mean.normal += r.normal / n;
    mean.slip += r.slip / n;
    mean.spin_i += r.spin_i / n;
    mean.spin_j += r.spin_j / n;
  }
  return mean;
}

}  // namespace furnas
