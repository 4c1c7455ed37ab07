#pragma once

#include "engine/base/vec3.h"

namespace furnas {

/// Constants of the damped Hookean contact of the study (arXiv 2105.00977), with k_n = 1.
struct HookeConstants {
  double tangential_stiffness = 1;  ///< k_t [k_n]
  double normal_damping = 0.5;      ///< gamma_n [1/time], times the reduced mass
  double tangential_damping = 0.5;  ///< gamma_t [1/time], times the reduced mass
  double friction = 0;              ///< Coulomb coefficient mu
  bool attraction = true;           ///< the normal force may turn negative while a contact opens
};

/// F_n = k_n overlap - m_eff gamma_n v_n, v_n the normal velocity (positive when the particles part).
template <class R>
R normal_force(const HookeConstants& c, R overlap, R reduced_mass, R normal_velocity) {
  const R force = overlap - reduced_mass * R(c.normal_damping) * normal_velocity;
  return c.attraction || force > R(0) ? force : R(0);
}

/// Energy taken out by the damping part of the normal force in a step, with v_n as in normal_force().
template <class R>
R normal_loss(R force, R overlap, R normal_velocity, R time_step) {
  return (overlap - force) * normal_velocity * time_step;
}

/// How the tangential spring and its damping went through a step.
template <class R>
struct TangentialStep {
  Vec3<R> before;   ///< history at its start, carried to its end [d_s]
  Vec3<R> after;    ///< history at its end [d_s]
  Vec3<R> way;      ///< slip of the surfaces within it [d_s]
  Vec3<R> damping;  ///< the force is -(k_t after + damping) [k_n d_s]
  Vec3<R> slip;     ///< slip velocity with which the damping works [d_s/time]
};

/// Energy that a tangential contact took out of the motion in a step: by its damping, and by its spring, with
/// the mean of the forces at both ends, as velocity Verlet pairs them, less what the spring has stored.
template <class R>
R tangential_loss(const HookeConstants& c, const TangentialStep<R>& s, R time_step) {
  return time_step * dot(s.damping, s.slip) +
         R(0.5) * R(c.tangential_stiffness) * dot(s.before + s.after, s.before + s.way - s.after);
}

/// Energy of a tangential spring [k_n d_s^2].
template <class R>
R tangential_energy(const HookeConstants& c, const Vec3<R>& history) {
  return R(0.5) * R(c.tangential_stiffness) * dot(history, history);
}

/// Energy of an overlap [k_n d_s^2].
template <class R>
R normal_energy(R overlap) {
  return R(0.5) * overlap * overlap;
}

}  // namespace furnas
