#pragma once

#include <Eigen/Core>
#include <vector>

#include "engine/certificate/backbone.h"
#include "engine/certificate/contact_network.h"

namespace furnas {

/// What the contacts at rest leave on a particle.
struct Residual {
  Vec3<double> force;   ///< net force [k_n d_s]
  Vec3<double> torque;  ///< net torque [k_n d_s^2]
};

/// Of each particle.
std::vector<Residual> residuals(const ContactNetwork& network);

/// How far a backbone is from rest, by its static forces alone.
struct Imbalance {
  double mean_force{}, largest_force{};    ///< |net force| of a member/mean |F| of all contacts
  double mean_torque{}, largest_torque{};  ///< |net torque|/(mean |F| R)
};

Imbalance imbalance(const ContactNetwork& network, const Backbone& backbone);

/// Sum of branch (x) force over the contacts, over V; positive in compression [k_n/d_s].
Eigen::Matrix3d static_stress(const ContactNetwork& network);

/// How the bonds of a backbone stand to the Coulomb limit.
struct FrictionState {
  double largest_excess{};  ///< largest |F_t| - mu F_n, over mu mean F_n; negative when all are below
  double least_normal{};    ///< smallest F_n/mean F_n
  std::int64_t sliding{};   ///< bonds at the limit
};

FrictionState friction_state(const ContactNetwork& network, const Backbone& backbone);

}  // namespace furnas
