#pragma once

#include <vector>

#include "engine/trials/balls.h"
#include "engine/trials/closed_form.h"

namespace furnas {

/// The result of a collision of two spheres.
struct Bounce {
  Packing end;               ///< packing after the contact has opened; particle 0 is i
  Vec3<double> approach;     ///< v_i - v_j at the end
  int steps{};               ///< number of steps at whose end the two overlapped
  double largest_overlap{};  ///< [d_s]
  int step_of_largest{};     ///< step of the largest overlap, counted like `steps`
};

/// Places i next to j along x such that their surfaces meet after one step plus the share `phase` of the next
/// step, and lets them collide. The positions in i and j are ignored. Takes at most `most_steps` steps.
Bounce bounce(const Model& model, Ball i, Ball j, double phase, int most_steps = 10000);

/// A time step, and the share of it after which the spheres meet.
struct EntryPhase {
  double time_step, entry;
};

inline constexpr int phase_count = 127;

/// Steps near `step`, each with an entry phase. The errors of a collision depend on the shares of a step
/// after which the spheres meet and part. Therefore both the entry phase and the step are varied, the step so
/// far that duration/step changes by one. The points form a lattice. Their number is prime, so that entry,
/// exit and the sum of both take each value exactly once.
std::vector<EntryPhase> phases_of_a_collision(double duration, double step);

/// Normal velocity, slip velocity of the surfaces and the two spins after a collision.
struct Rebound {
  double normal{}, slip{}, spin_i{}, spin_j{};
};

/// Collisions of spheres without spin, with a normal and a tangential speed, in steps near that of `model`:
/// one rebound for each entry phase.
std::vector<Rebound> rebounds(const Model& model, double normal_speed, double tangential_speed,
                              double radius_i, double radius_j);

/// The mean of several rebounds.
Rebound mean_of(const std::vector<Rebound>& rebounds);

/// The mean rebound under a law.
template <class Law>
Rebound collide(const HookeConstants& constants, double step, double normal_speed, double tangential_speed,
                double radius_i, double radius_j) {
  return mean_of(
      rebounds(model_of<Law>(constants, step), normal_speed, tangential_speed, radius_i, radius_j));
}

}  // namespace furnas
