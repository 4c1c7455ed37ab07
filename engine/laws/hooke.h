#pragma once

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

}  // namespace furnas
