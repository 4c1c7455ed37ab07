#pragma once

#include "engine/laws/hooke.h"
#include "engine/laws/touch.h"

namespace furnas {

/// Carries a vector across the rotation that takes the unit normal `from` to `to`, about the axis
/// from x to: exact, keeps its length and its angle with the normal.
template <class R>
[[gnu::always_inline]] inline Vec3<R> transport(const Vec3<R>& vector, const Vec3<R>& from,
                                                const Vec3<R>& to) {
  return vector - (dot(vector, to) / (R(1) + dot(from, to))) * (from + to);
}

/// Turns a vector about `normal` by an angle, to third order in it, without changing its length.
template <class R>
[[gnu::always_inline]] inline Vec3<R> turn(const Vec3<R>& vector, const Vec3<R>& normal, R angle) {
  const R t = R(0.5) * angle;
  const R scale = R(1) / (R(1) + t * t);
  return ((R(1) - t * t) * scale) * vector + (R(2) * t * scale) * cross(normal, vector);
}

/// The damped Hookean contact with friction, each quantity taken at the instant it belongs to.
///
/// The slip of a step is measured in its middle, with the normal and the lever arms of the middle
/// (Vyas, Ottino, Lueptow, Umbanhowar, Comput. Phys. Commun. 310 (2025) 109524); the history turns with
/// the pair, about the normal too; damping uses velocities predicted for the end of the step. The lever
/// arms meet in the contact point, the same for slip and torque, so angular momentum is conserved.
struct HookeSynchronized {
  static constexpr const char* name = "hooke_synchronized";
  static constexpr bool spins = true;
  static constexpr bool synchronized = true;

  HookeConstants constants;

  /// `history` is the tangential displacement xi of i against j [d_s].
  template <class R>
  [[gnu::always_inline]] Reaction<R> operator()(const Touch<R>& t, Vec3<R>& history) const {
    const R half = R(0.5);
    const Vec3<R> n = t.branch * (R(1) / t.distance);
    Vec3<R> before = history;
    Vec3<R> way{};
    if (t.time_step > R(0)) age(t, n, history, before, way);

    const R shortening = half * t.overlap;
    const R v_n = dot(t.now.velocity, n);
    const R f_n = normal_force(constants, t.overlap, t.reduced_mass, v_n);
    const Vec3<R> slip = slip_velocity(t.now, n, t.radius_i - shortening, t.radius_j - shortening);
    const Vec3<R> damping = (t.reduced_mass * R(constants.tangential_damping)) * slip;
    const R stiffness(constants.tangential_stiffness);
    Vec3<R> f_t = -(stiffness * history + damping);
    const R size = norm(f_t);
    const R limit = R(constants.friction) * std::abs(f_n);
    if (size > limit) {
      f_t *= limit / size;
      if (stiffness > R(0)) history = -(f_t + damping) * (R(1) / stiffness);
    }
    const R loss =
        tangential_loss(constants, TangentialStep<R>{before, history, way, damping, slip}, t.time_step);
    const R sliding = size > limit ? loss : R(0);
    return {f_n * n + f_t,
            t.overlap,
            shortening,
            {normal_loss(f_n, t.overlap, v_n, t.time_step), loss - sliding, sliding}};
  }

 private:
  /// Takes the history through the step: carries it to the middle, adds the slip there, carries it to the
  /// end. `way` is the slip of the whole step, `before` the history without it.
  template <class R>
  [[gnu::always_inline]] static void age(const Touch<R>& t, const Vec3<R>& end, Vec3<R>& history,
                                         Vec3<R>& before, Vec3<R>& way) {
    const R half = R(0.5);
    const Vec3<R> step = t.time_step * t.drift;
    const Vec3<R> branch_start = t.branch - step;
    // Centres that passed each other within the step: nothing of the old contact plane is left.
    if (dot(branch_start, t.branch) <= R(0)) {
      history = before = {};
      return;
    }
    const Vec3<R> branch_middle = t.branch - half * step;
    const R distance_start = norm(branch_start);
    const R distance_middle = norm(branch_middle);
    const Vec3<R> start = branch_start * (R(1) / distance_start);
    const Vec3<R> middle = branch_middle * (R(1) / distance_middle);

    // Spheres that met within the step have slipped on each other only since then.
    const R reach = t.radius_i + t.radius_j;
    const R share = distance_start > reach ? t.overlap / (distance_start - t.distance) : R(1);

    const R shortening = half * (reach - distance_middle);
    const Vec3<R> slip = slip_velocity(t.midway, middle, t.radius_i - shortening, t.radius_j - shortening);
    const R twist = (half * t.time_step) * dot(t.midway.spin_i + t.midway.spin_j, middle);
    const Vec3<R> increment = (share * t.time_step) * slip;
    const Vec3<R> xi =
        transport(turn(transport(history, start, middle), middle, twist) + increment, middle, end);
    history = xi - dot(xi, end) * end;  // rounding alone: xi is across the normal already
    before = history - increment;       // but for the turn of the normal within half a step
    way = t.time_step * slip;
  }
};

}  // namespace furnas
