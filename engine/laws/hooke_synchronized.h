#pragma once

#include "engine/laws/hooke.h"
#include "engine/laws/touch.h"

namespace furnas {

/// Carries a vector across the rotation that takes the unit normal `from` to `to`, about the axis from x to.
/// The result is exact: length and angle with the normal are kept.
template <class R>
[[gnu::always_inline]] inline Vec3<R> transport(const Vec3<R>& vector, const Vec3<R>& from,
                                                const Vec3<R>& to) {
  return vector - (dot(vector, to) / (R(1) + dot(from, to))) * (from + to);
}

/// Turns a vector about `normal` by an angle. The length is exact, the angle accurate to its third order.
template <class R>
[[gnu::always_inline]] inline Vec3<R> turn(const Vec3<R>& vector, const Vec3<R>& normal, R angle) {
  const R t = R(0.5) * angle;
  const R scale = R(1) / (R(1) + t * t);
  return ((R(1) - t * t) * scale) * vector + (R(2) * t * scale) * cross(normal, vector);
}

/// The damped Hookean contact with friction, with each quantity at its proper instant.
///
/// The slip of a step is measured in its middle, with the normal and the lever arms of the middle (Vyas,
/// Ottino, Lueptow, Umbanhowar, Comput. Phys. Commun. 310 (2025) 109524); the history turns with the pair,
/// also about the normal; damping uses velocities predicted for the end of the step. The lever arms meet in
/// the contact point and are the same for slip and torque, so angular momentum is conserved.
struct HookeSynchronized {
  static constexpr const char* name = "hooke_synchronized";
  static constexpr bool spins = true;
  static constexpr bool synchronized = true;
  static constexpr bool arms_meet = true;

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
    const R shortening = R(0.5) * t.overlap;
    SpringStep<R> spring = aged(t, n, history);
    spring.slip = slip_velocity(t.now, n, t.radius_i - shortening, t.radius_j - shortening);
    const auto never = R(1) < R(0);
    return hooke_reaction(constants, t, hooke_spring(t), n, dot(t.now.velocity, n), shortening, spring, never,
                          history);
  }

  /// Updates the history over the step: turns it to the middle of the step, adds the slip there, and turns
  /// the sum to the end. A step of length 0 does not change the history. Laws with another normal spring can
  /// use the function, too.
  template <class R>
  [[gnu::always_inline]] static SpringStep<R> aged(const Touch<R>& t, const Vec3<R>& end, Vec3<R>& history) {
    const R half(0.5);
    const Vec3<R> step = t.time_step * t.drift;
    const Vec3<R> branch_start = t.branch - step;
    const Vec3<R> branch_middle = t.branch - half * step;
    const R distance_start = norm(branch_start);
    const R distance_middle = norm(branch_middle);
    // If the centres passed each other within the step, the old contact plane has no meaning any more.
    const auto passed = dot(branch_start, t.branch) <= R(0);
    const Vec3<R> start = branch_start * (R(1) / select(passed, R(1), distance_start));
    const Vec3<R> middle = branch_middle * (R(1) / select(passed, R(1), distance_middle));

    // Spheres that met within the step have slipped only since they met.
    const R reach = t.radius_i + t.radius_j;
    const auto met = distance_start > reach;
    const R share = select(met, t.overlap / select(met, distance_start - t.distance, R(1)), R(1));

    const R shortening = half * (reach - distance_middle);
    const Vec3<R> slip = slip_velocity(t.midway, middle, t.radius_i - shortening, t.radius_j - shortening);
    const R twist = (half * t.time_step) * dot(t.midway.spin_i + t.midway.spin_j, middle);
    const Vec3<R> increment = (share * t.time_step) * slip;
    const Vec3<R> at_middle =
        turn(select(passed, Vec3<R>{}, transport(history, start, middle)), middle, twist);
    const Vec3<R> xi = transport(at_middle + increment, middle, end);
    const auto still = passed | (t.time_step <= R(0));
    // xi is already perpendicular to the normal; this removes the rounding error.
    history = select(still, select(passed, Vec3<R>{}, history), xi - dot(xi, end) * end);
    // Neglects the turn of the normal within half a step.
    const Vec3<R> before = select(still, history, history - increment);
    return {before, select(still, Vec3<R>{}, t.time_step * slip), {}};
  }
};

}  // namespace furnas
