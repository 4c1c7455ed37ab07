#pragma once

#include "engine/laws/hooke.h"
#include "engine/laws/touch.h"

namespace furnas {

/// The scene without friction: no spin, no history, no torque. Equal to HookeSynchronized at mu = 0, or
/// with `legacy` to HookeHistory at mu = 0.
template <bool legacy>
struct Frictionless {
  static constexpr const char* name = legacy ? "hooke_history" : "hooke_synchronized";
  static constexpr bool spins = false;
  static constexpr bool synchronized = !legacy;

  HookeConstants constants;

  template <class R>
  [[gnu::always_inline]] Reaction<R> operator()(const Touch<R>& t, Vec3<R>&) const {
    const Vec3<R> n = t.branch * (R(1) / t.distance);
    const Vec3<R>& velocity = synchronized ? t.now.velocity : t.midway.velocity;
    const R v_n = dot(velocity, n);
    const R f_n = normal_force(constants, t.overlap, t.reduced_mass, v_n);
    return {f_n * n, t.overlap, R(0), {normal_loss(f_n, t.overlap, v_n, t.time_step)}};
  }
};

}  // namespace furnas
