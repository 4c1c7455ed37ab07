#pragma once

#include "engine/laws/hooke.h"
#include "engine/laws/touch.h"

namespace furnas {

/// The law without friction: no spin, no history, no torque. Equal to HookeSynchronized at mu = 0, or
/// with `legacy` to HookeHistory at mu = 0.
template <bool legacy>
struct Frictionless {
  static constexpr const char* name = legacy ? "hooke_history" : "hooke_synchronized";
  static constexpr bool spins = false;
  static constexpr bool synchronized = !legacy;
  static constexpr bool arms_meet = !legacy;

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

  template <class R>
  [[gnu::always_inline]] Reaction<R> operator()(const Touch<R>& t, Vec3<R>&) const {
    const Vec3<R> n = t.branch * (R(1) / t.distance);
    const Vec3<R>& velocity = synchronized ? t.now.velocity : t.midway.velocity;
    const R v_n = dot(velocity, n);
    const R spring = hooke_spring(t);
    const R f_n = normal_force(constants, spring, t.reduced_mass, v_n);
    return {f_n * n, spring, R(0), {normal_loss(f_n, spring, v_n, t.time_step)}};
  }
};

}  // namespace furnas
