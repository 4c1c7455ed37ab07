#pragma once

#include "engine/base/vec3.h"

namespace furnas {

/// Relative motion of the two particles of a contact at one instant.
template <class R>
struct RelativeMotion {
  Vec3<R> velocity;  ///< v_i - v_j [d_s/time]
  Vec3<R> spin_i;    ///< [1/time]
  Vec3<R> spin_j;    ///< [1/time]
};

/// The input of a law: two particles that overlap at the end of a step.
template <class R>
struct Touch {
  Vec3<R> branch;            ///< centre of j to centre of i [d_s]
  R distance;                ///< |branch| [d_s]
  R overlap;                 ///< R_i + R_j - distance > 0 [d_s]
  R radius_i, radius_j;      ///< [d_s]
  R reduced_mass;            ///< m_i m_j/(m_i + m_j) [rho d_s^3]
  RelativeMotion<R> midway;  ///< in the middle of the step, as it moved the particles
  RelativeMotion<R> now;     ///< predicted for the end of the step; only if the law is synchronized
  Vec3<R> drift;             ///< rate of change of the branch over the step, the cell's flow included
  R time_step;               ///< [time]; 0 when forces are computed without a step
};

/// Energy that a contact dissipates during the step [k_n d_s^2].
template <class R>
struct ContactLosses {
  R normal_damping{};
  R tangential_damping{};
  R sliding{};  ///< all work of the tangential force in steps that end at the Coulomb limit
};

/// Force, stiffness and damping of the springs and dashpots of a contact: the result of a law's stiffness().
struct ContactStiffness {
  double push{};                ///< normal force of the spring [k_n d_s]
  double normal{};              ///< dF_n/d overlap of the spring [k_n]
  double tangential{};          ///< dF_t/d xi of the spring; 0 for a law without friction [k_n]
  double normal_damping{};      ///< damping coefficient of the normal velocity/reduced mass [1/time]
  double tangential_damping{};  ///< damping coefficient of the slip velocity/reduced mass [1/time]

  /// The stiffness k with which k/m_eff is the largest squared frequency of the pair [k_n]. For slip the
  /// inverse mass is 7/2 of 1/m_eff, because the spheres also rotate.
  [[gnu::always_inline]] double stiffest() const {
    return 3.5 * tangential > normal ? 3.5 * tangential : normal;
  }
};

/// Energy of the springs of a contact [k_n d_s^2]: the result of a law's energy().
struct ContactEnergy {
  double normal{};
  double tangential{};
};

/// Two spheres in contact without any motion: the argument for stiffness() and energy().
[[gnu::always_inline]] inline Touch<double> resting_touch(double radius_i, double radius_j,
                                                          double reduced_mass, double overlap) {
  Touch<double> touch{};
  touch.distance = radius_i + radius_j - overlap;
  touch.overlap = overlap;
  touch.radius_i = radius_i;
  touch.radius_j = radius_j;
  touch.reduced_mass = reduced_mass;
  return touch;
}

/// The result of a law.
template <class R>
struct Reaction {
  Vec3<R> force;    ///< on i; on j it is the opposite [k_n d_s]
  R normal_spring;  ///< the elastic part of the normal force, along the branch [k_n d_s]
  R shortening{};   ///< lever arms are R - shortening; overlap/2 if they meet in the contact, else 0 [d_s]
  ContactLosses<R> losses{};
};

/// Slip velocity of the surfaces at the contact: the part of v_i - v_j - (a_i w_i + a_j w_j) x n across n.
template <class R>
[[gnu::always_inline]] inline Vec3<R> slip_velocity(const RelativeMotion<R>& motion, const Vec3<R>& normal,
                                                    R arm_i, R arm_j) {
  const Vec3<R>& v = motion.velocity;
  return v - dot(v, normal) * normal - cross(arm_i * motion.spin_i + arm_j * motion.spin_j, normal);
}

}  // namespace furnas
