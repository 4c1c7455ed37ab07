#include "engine/certificate/statics.h"

#include <algorithm>
#include <limits>
#include <numbers>

namespace furnas {

std::vector<Residual> residuals(const ContactNetwork& network) {
  std::vector<Residual> of(network.radius.size());
  for (const StaticContact& c : network.contacts) {
    const Vec3<double> f = c.force();
    const Vec3<double> couple = cross(c.normal, c.tangential_force);
    of[c.i].force += f;
    of[c.j].force -= f;
    of[c.i].torque -= c.arm_i * couple;
    of[c.j].torque -= c.arm_j * couple;
  }
  return of;
}

Imbalance imbalance(const ContactNetwork& network, const Backbone& backbone) {
  const std::vector<Residual> residual = residuals(network);
  const double pressure = static_stress(network).trace() / 3;
  Imbalance found;
  for (const std::uint32_t k : backbone.particles) {
    const double r = network.radius[k];
    const double load = std::max(network.mean_force, pressure * std::numbers::pi * r * r);
    const double f = norm(residual[k].force);
    const double t = norm(residual[k].torque) / r;
    found.mean_force += f;
    found.mean_torque += t;
    found.largest_force = std::max(found.largest_force, f / load);
    found.largest_torque = std::max(found.largest_torque, t / load);
  }
  const double all = network.mean_force * static_cast<double>(backbone.particles.size());
  found.mean_force /= all;
  found.mean_torque /= all;
  return found;
}

Eigen::Matrix3d static_stress(const ContactNetwork& network) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (const StaticContact& c : network.contacts) {
    const Vec3<double> f = c.force();
    sum += Eigen::Vector3d(c.branch.x, c.branch.y, c.branch.z) * Eigen::RowVector3d(f.x, f.y, f.z);
  }
  return sum / network.volume;
}

FrictionState friction_state(const ContactNetwork& network, const Backbone& backbone) {
  const double mu = network.springs.friction();
  FrictionState state;
  state.largest_excess = -std::numeric_limits<double>::infinity();
  state.least_normal = std::numeric_limits<double>::infinity();
  for (const StaticContact* c : backbone.bonds) {
    state.least_normal = std::min(state.least_normal, c->normal_force / network.mean_normal_force);
    state.sliding += c->sliding;
    if (network.frictional())
      state.largest_excess =
          std::max(state.largest_excess,
                   (norm(c->tangential_force) - mu * c->normal_force) / (mu * network.mean_normal_force));
  }
  return state;
}

}  // namespace furnas
