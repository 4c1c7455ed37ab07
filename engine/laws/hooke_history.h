#pragma once

#include "engine/laws/hooke.h"
#include "engine/laws/touch.h"

namespace furnas {

/// The law of `pair_style gran/hooke/history` of LAMMPS, which the paper used, reproduced step by step.
///
/// As in LAMMPS, the law combines quantities of different instants: velocities in the middle of the step, and
/// the normal at its end. The tangential history is projected onto the new contact plane, which shortens it.
/// The lever arms are the full radii. docs/results/verification.md shows the effect on a small sphere between
/// large ones.
struct HookeHistory {
  static constexpr const char* name = "hooke_history";
  static constexpr bool spins = true;
  static constexpr bool synchronized = false;
  static constexpr bool arms_meet = false;

  HookeConstants constants;

  /// Push, stiffness and damping at this overlap, for all that is not a step: certificate, search for a
  /// minimum, choice of the time step.
  [[gnu::always_inline]] ContactStiffness stiffness(const Touch<double>& t) const {
    return hooke_stiffness(constants, t, spins);
  }
  /// The energy stored in the springs of the contact.
  [[gnu::always_inline]] ContactEnergy energy(const Touch<double>& t, const Vec3<double>& history) const {
    return hooke_energy(constants, t, history);
  }

  /// `history` is the tangential displacement xi of i against j [d_s].
  template <class R>
  [[gnu::always_inline]] Reaction<R> operator()(const Touch<R>& t, Vec3<R>& history) const {
    const Vec3<R> n = t.branch * (R(1) / t.distance);
    const Vec3<R> slip = slip_velocity(t.midway, n, t.radius_i, t.radius_j);
    const Vec3<R> before = history;
    const Vec3<R> increment = slip * t.time_step;
    history += increment;
    const auto fresh = is_zero(history);
    history = select(t.time_step > R(0), history - dot(history, n) * n, history);
    return hooke_reaction(constants, t, hooke_spring(t), n, dot(t.midway.velocity, n), R(0),
                          SpringStep<R>{before, increment, slip}, fresh, history);
  }
};

}  // namespace furnas
