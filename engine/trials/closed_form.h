#pragma once

#include <cmath>
#include <numbers>

namespace furnas {

/// The head-on collision with k_n = 1 under overlap'' + gamma overlap' + overlap/m_eff = 0.
struct HeadOn {
  double damping;  ///< gamma [1/time]
  double mass;     ///< m_eff [rho d_s^3]

  double half_damping() const { return damping / 2; }
  double undamped() const { return std::sqrt(1 / mass); }
  double frequency() const { return std::sqrt(1 / mass - damping * damping / 4); }
  double duration() const { return std::numbers::pi / frequency(); }
  double restitution() const { return std::exp(-half_damping() * duration()); }

  /// Time of the largest overlap, and the largest overlap for a unit speed of approach.
  double time_of_largest() const { return std::atan2(2 * frequency(), damping) / frequency(); }
  double largest_overlap() const { return std::exp(-half_damping() * time_of_largest()) / undamped(); }

  /// Restitution if the contact ends as soon as the force would become attractive.
  double restitution_without_attraction() const {
    const double b = half_damping();
    const double w = frequency();
    return std::exp(-b / w * (std::numbers::pi - std::atan2(2 * b * w, w * w - b * b)));
  }

  /// Integral of |F_n|/(m_eff v) over the collision. |F_n| is needed because in the law friction also acts
  /// while F_n is attractive.
  double absolute_impulse() const { return 1 + 2 * restitution_without_attraction() - restitution(); }

  /// The collision, to second order in the step, if the damping uses the velocity of half a step earlier: the
  /// delayed force -m gamma (v - a dt/2) reduces the mass by the share gamma dt/2.
  HeadOn lagged(double time_step) const {
    const double lighter = 1 - damping * time_step / 2;
    return {damping / lighter, mass * lighter};
  }
};

/// The slip xi of two spheres of any sizes in a sticking contact: xi'' + (7/2) (gamma_t xi' + k_t xi/m_eff) =
/// 0.
struct Sticking {
  double half_damping;  ///< b [1/time]
  double square;        ///< (7/2) k_t/m_eff [1/time^2]

  static Sticking of(double damping, double mass) { return {1.75 * damping, 3.5 / mass}; }

  /// xi' at time t from xi = 0, xi' = 1.
  double slip(double t) const {
    const double w = std::sqrt(square - half_damping * half_damping);
    return std::exp(-half_damping * t) * (std::cos(w * t) - half_damping / w * std::sin(w * t));
  }

  /// xi' at time t from xi = 1, xi' = 0.
  double slip_of_displacement(double t) const {
    const double w = std::sqrt(square - half_damping * half_damping);
    return -std::exp(-half_damping * t) * square / w * std::sin(w * t);
  }

  /// As HeadOn::lagged.
  Sticking lagged(double time_step) const {
    const double lighter = 1 - half_damping * time_step;
    return {half_damping / lighter, square / lighter};
  }
};

}  // namespace furnas
