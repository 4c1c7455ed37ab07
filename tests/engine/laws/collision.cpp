#include "tests/engine/laws/collision.h"

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

std::vector<Phase> phases_of_a_collision(double duration, double step) {
  constexpr int generator = 78;
  std::vector<Phase> phases;
  for (int n = 0; n < phase_count; ++n) {
    const double exit = static_cast<double>(n * generator % phase_count) / phase_count;
    phases.push_back({duration / (duration / step + exit), (n + 0.5) / phase_count});
  }
  return phases;
}

}  // namespace furnas
