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
  Reaction<R> operator()(const Touch<R>& t, Vec3<R>&) const {
    const Vec3<R> n = t.branch * (R(1) / t.distance);
    const Vec3<R>& velocity = synchronized ? t.now.velocity : t.midway.velocity;
    return {normal_force(constants, t.overlap, t.reduced_mass, dot(velocity, n)) * n, R(0)};
  }
};

}  // namespace furnas
