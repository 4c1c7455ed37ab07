#pragma once

#include "engine/base/select.h"
#include "engine/base/vec3.h"
#include "engine/laws/touch.h"

namespace furnas {

/// Constants of the damped Hookean contact of the paper (arXiv 2105.00977), with k_n = 1.
struct HookeConstants {
  double tangential_stiffness = 1;  ///< k_t [k_n]
  double normal_damping = 0.5;      ///< gamma_n [1/time], times the reduced mass
  double tangential_damping = 0.5;  ///< gamma_t [1/time], times the reduced mass
  double friction = 0;              ///< Coulomb coefficient mu
  bool attraction = true;           ///< the normal force may turn negative while a contact opens
  bool winding = true;              ///< damping may stretch the spring of a sliding contact beyond mu F_n/k_t
};

/// The spring of the normal force, k_n overlap with k_n = 1 [k_n d_s].
template <class R>
[[gnu::always_inline]] inline R hooke_spring(const Touch<R>& t) {
  return t.overlap;
}

/// Push, stiffness and damping of a Hookean contact; without spins there is no tangential force.
[[gnu::always_inline]] inline ContactStiffness hooke_stiffness(const HookeConstants& c,
                                                               const Touch<double>& t, bool spins) {
  constexpr double k_n = 1;
  if (!spins) return {hooke_spring(t), k_n, 0, c.normal_damping, 0};
  return {hooke_spring(t), k_n, c.tangential_stiffness, c.normal_damping, c.tangential_damping};
}

/// Energy of a Hookean contact, k_n overlap^2/2 and k_t xi^2/2.
[[gnu::always_inline]] inline ContactEnergy hooke_energy(const HookeConstants& c, const Touch<double>& t,
                                                         const Vec3<double>& history) {
  return {0.5 * t.overlap * t.overlap, 0.5 * c.tangential_stiffness * dot(history, history)};
}

/// F_n = spring - m_eff gamma_n v_n, v_n the normal velocity (positive when the particles part).
template <class R>
[[gnu::always_inline]] inline R normal_force(const HookeConstants& c, const R& spring, const R& reduced_mass,
                                             const R& normal_velocity) {
  const R force = spring - reduced_mass * R(c.normal_damping) * normal_velocity;
  return c.attraction ? force : larger(force, R(0));
}

/// Energy dissipated by the damping part of the normal force in a step, with v_n as in normal_force().
template <class R>
[[gnu::always_inline]] inline R normal_loss(const R& force, const R& spring, const R& normal_velocity,
                                            const R& time_step) {
  return (spring - force) * normal_velocity * time_step;
}

/// The change of a tangential spring within a step, before it is cut to Coulomb's limit.
template <class R>
struct SpringStep {
  Vec3<R> before;     ///< history at the start of the step, carried to the contact plane at its end [d_s]
  Vec3<R> increment;  ///< tangential displacement of the surfaces within the step [d_s]
  Vec3<R> slip;       ///< slip velocity that the damping force opposes [d_s/time]
};

/// Force and losses of a contact, from the normal force `spring`, the velocity `v_n` along the normal `n` and
/// the tangential spring `s`. `history` is the tangential spring at the end of the step. It is cut so that
/// the sum of spring force and damping force does not exceed Coulomb's limit. If `slides_free`, a contact
/// beyond the limit has no tangential force and keeps its history. Lever arms are R - `shortening`.
///
/// With winding, as in the paper, the damping force of a sliding contact is that of the whole slip. If this
/// force exceeds the limit, the spring is stretched in the opposite direction until the sum is at the limit.
/// Without winding, a slider is in series with spring and dashpot. The force of spring and dashpot together
/// is the limit, which determines their rate; the slider takes the rest of the slip.
///
/// The loss of the spring in a step is the work of the mean of its forces at both ends of the step, as in
/// velocity Verlet, minus the energy that the spring has stored.
template <class R, class Truth>
[[gnu::always_inline]] inline Reaction<R> hooke_reaction(const HookeConstants& c, const Touch<R>& t,
                                                         const R& spring, const Vec3<R>& n, const R& v_n,
                                                         const R& shortening, const SpringStep<R>& s,
                                                         const Truth& slides_free, Vec3<R>& history) {
  using std::abs;
  const R f_n = normal_force(c, spring, t.reduced_mass, v_n);
  const R stiffness(c.tangential_stiffness);
  const R dashpot = t.reduced_mass * R(c.tangential_damping);
  Vec3<R> damping = dashpot * s.slip;
  Vec3<R> f_t = -(stiffness * history + damping);
  const R size = norm(f_t);
  const R limit = R(c.friction) * abs(f_n);
  const auto slides = size > limit;
  // Within the limit the factor is exactly 1. `least` only avoids 0/0.
  const R least(1e-37);
  f_t *= select(slides & slides_free, R(0), limit / larger(larger(size, limit), least));
  if (c.tangential_stiffness > 0) {
    const Vec3<R> cut = c.winding ? -(f_t + damping) * R(1 / c.tangential_stiffness)
                                  : (dashpot * s.before - t.time_step * f_t) *
                                        (R(1) / larger(dashpot + t.time_step * stiffness, least));
    history = select(slides, select(slides_free, history, cut), history);
  }
  // Without a spring that could wind, only the force that acts does work.
  if (!c.winding || c.tangential_stiffness == 0)
    damping = select(slides, select(slides_free, damping, -(f_t + stiffness * history)), damping);
  const R loss = t.time_step * dot(damping, s.slip) +
                 R(0.5) * stiffness * dot(s.before + history, s.before + s.increment - history);
  const R sliding = select(slides, loss, R(0));
  return {f_n * n + f_t,
          spring,
          shortening,
          {normal_loss(f_n, spring, v_n, t.time_step), loss - sliding, sliding}};
}

}  // namespace furnas
