#pragma once

#include <vector>

#include "engine/trials/balls.h"
#include "engine/trials/closed_form.h"

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
struct EntryPhase {
  double time_step, entry;
};

inline constexpr int phase_count = 127;

/// Steps near `step` and phases of the entry. Errors of a collision depend on the shares of a step after
/// which the spheres meet and part, so the step is varied until duration/step has run through a whole number.
/// The points form a lattice; they are a prime, so entry, exit and their sum take each value once.
std::vector<EntryPhase> phases_of_a_collision(double duration, double step);

/// After a collision: normal velocity and slip of the surfaces, and the two spins.
struct Rebound {
  double normal{}, slip{}, spin_i{}, spin_j{};
};

/// Spheres without spin that meet with a normal and a tangential speed, in steps near that of `model`: one
/// rebound for each phase.
std::vector<Rebound> rebounds(const Model& model, double normal_speed, double tangential_speed,
                              double radius_i, double radius_j);

/// Their mean.
Rebound mean_of(const std::vector<Rebound>& rebounds);

/// Mean rebound of a law.
template <class Law>
Rebound collide(const HookeConstants& constants, double step, double normal_speed, double tangential_speed,
                double radius_i, double radius_j) {
  return mean_of(
      rebounds(model_of<Law>(constants, step), normal_speed, tangential_speed, radius_i, radius_j));
}

}  // namespace furnas
