#pragma once

#include "engine/laws/hooke.h"
#include "engine/laws/touch.h"

namespace furnas {

/// The law of `pair_style gran/hooke/history` of LAMMPS, step for step, which the study used.
///
/// It mixes instants on purpose: the velocities are those of the middle of the step, the normal that of
/// its end; the tangential history is projected on the new contact plane without keeping its length;
/// the lever arms are the full radii. docs/verification.md shows what that does to a small sphere between
/// large ones.
struct HookeHistory {
  static constexpr const char* name = "hooke_history";
  static constexpr bool spins = true;
  static constexpr bool synchronized = false;

  HookeConstants constants;

  /// `history` is the tangential displacement xi of i against j [d_s].
  template <class R>
  [[gnu::always_inline]] Reaction<R> operator()(const Touch<R>& t, Vec3<R>& history) const {
    const R stiffness(constants.tangential_stiffness);
    const Vec3<R> n = t.branch * (R(1) / t.distance);
    const R v_n = dot(t.midway.velocity, n);
    const R f_n = normal_force(constants, t.overlap, t.reduced_mass, v_n);

    const Vec3<R> slip = slip_velocity(t.midway, n, t.radius_i, t.radius_j);
    const Vec3<R> before = history;
    const Vec3<R> way = slip * t.time_step;
    history += way;
    const bool fresh = history == Vec3<R>{};
    if (t.time_step > R(0)) history -= dot(history, n) * n;

    const Vec3<R> damping = (t.reduced_mass * R(constants.tangential_damping)) * slip;
    Vec3<R> f_t = -(stiffness * history + damping);
    const R size = norm(f_t);
    const R limit = R(constants.friction) * std::abs(f_n);
    if (size > limit) {
      if (fresh) {
        f_t = {};
      } else {
        f_t *= limit / size;
        if (stiffness > R(0)) history = -(f_t + damping) * (R(1) / stiffness);
      }
    }
    const R loss =
        tangential_loss(constants, TangentialStep<R>{before, history, way, damping, slip}, t.time_step);
    const R sliding = size > limit ? loss : R(0);
    return {f_n * n + f_t,
            t.overlap,
            R(0),
            {normal_loss(f_n, t.overlap, v_n, t.time_step), loss - sliding, sliding}};
  }
};

}  // namespace furnas
