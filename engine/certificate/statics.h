#pragma once

#include <Eigen/Core>
#include <vector>

#include "engine/certificate/backbone.h"
#include "engine/certificate/contact_network.h"

namespace furnas {

/// Net force and torque of the contacts at rest on a particle.
struct Residual {
  Vec3<double> force;   ///< net force [k_n d_s]
  Vec3<double> torque;  ///< net torque [k_n d_s^2]
};

/// The residual of each particle.
std::vector<Residual> residuals(const ContactNetwork& network);

/// How far a backbone is from rest, by its static forces alone. The load of a particle is the larger of the
/// mean |F| of all contacts and p pi R^2, the force of the pressure on its cross-section. The load takes into
/// account that contact forces between large spheres are (R/R_s)^2 times those between small ones, so their
/// net forces may be larger in proportion.
struct Imbalance {
  double mean_force{};      ///< |net force| of a member/mean |F| of all contacts
  double mean_torque{};     ///< |net torque|/(mean |F| R)
  double largest_force{};   ///< |net force|/load
  double largest_torque{};  ///< |net torque|/(load R)
};

/// Net forces and torques on the particles of the backbone.
Imbalance imbalance(const ContactNetwork& network, const Backbone& backbone);

/// Sum of branch (x) force over the contacts, over V; positive in compression [k_n/d_s].
Eigen::Matrix3d static_stress(const ContactNetwork& network);

/// The bonds of a backbone compared with the Coulomb limit.
struct FrictionState {
  double largest_excess{};  ///< largest (|F_t| - mu F_n)/(mu mean F_n); negative if all are below the limit
  double least_normal{};    ///< smallest F_n/mean F_n
  std::int64_t sliding{};   ///< bonds at the limit
};

/// How near the contacts of the backbone are to Coulomb's limit.
FrictionState friction_state(const ContactNetwork& network, const Backbone& backbone);

}  // namespace furnas
