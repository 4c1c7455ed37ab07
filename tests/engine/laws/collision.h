#pragma once

#include <vector>

#include "tests/engine/closed_form.h"
#include "tests/engine/support/setups.h"

namespace furnas {

/// What became of two spheres that met.
struct Bounce {
  Packing end;               ///< after the contact has opened; particle 0 is i
  Vec3<double> approach;     ///< v_i - v_j at the end
  int steps{};               ///< at whose end the two overlapped
  double largest_overlap{};  ///< [d_s]
  int step_of_largest{};     ///< counted like `steps`
};

/// Sets i beside j along x so that their surfaces meet after one step and the share `phase` of the next,
/// and lets them collide. Positions in the balls are ignored. At most `most_steps` are taken.
Bounce bounce(const Model& model, Ball i, Ball j, double phase, int most_steps = 10000);

/// A step, and the share of it after which the spheres meet.
struct Phase {
  double time_step, entry;
};

inline constexpr int phase_count = 127;

/// Steps near `step` and phases of the entry. Errors of a collision depend on the shares of a step after
/// which the spheres meet and part, so the step is varied until duration/step has run through a whole number.
/// The points form a lattice; they are a prime, so entry, exit and their sum take each value once.
std::vector<Phase> phases_of_a_collision(double duration, double step);

/// After a collision: slip of the surfaces and the two spins, means over the phases.
struct Rebound {
  double slip{}, spin_i{}, spin_j{};
};

/// Spheres without spin that meet with a normal and a tangential speed, in steps near `step`.
template <class Law>
Rebound collide(const HookeConstants& constants, double step, double normal_speed, double tangential_speed,
                double radius_i, double radius_j) {
  const double duration = HeadOn{constants.normal_damping, reduced_mass_of(radius_i, radius_j)}.duration();
  Rebound mean;
  for (const Phase& phase : phases_of_a_collision(duration, step)) {
    const Bounce b = bounce(model_of<Law>(constants, phase.time_step),
                            {.velocity = {-normal_speed, tangential_speed, 0}, .radius = radius_i},
                            {.radius = radius_j}, phase.entry);
    const Packing& p = b.end;
    mean.slip += (b.approach.y - radius_i * p.spin[0].z - radius_j * p.spin[1].z) / phase_count;
    mean.spin_i += p.spin[0].z / phase_count;
    mean.spin_j += p.spin[1].z / phase_count;
  }
  return mean;
}

}  // namespace furnas
