#include "engine/certificate/statics.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace furnas {

Imbalance imbalance(const ContactNetwork& network, const Backbone& backbone) {
  std::vector<Vec3<double>> force(network.radius.size());
  std::vector<Vec3<double>> torque(network.radius.size());
  for (const StaticContact& c : network.contacts) {
    const Vec3<double> f = c.force();
    const Vec3<double> couple = cross(c.normal, c.tangential_force);
    force[c.i] += f;
    force[c.j] -= f;
    torque[c.i] -= c.arm_i * couple;
    torque[c.j] -= c.arm_j * couple;
  }
  Imbalance found;
  for (const std::uint32_t k : backbone.particles) {
    const double f = norm(force[k]) / network.mean_force;
    const double t = norm(torque[k]) / (network.mean_force * network.radius[k]);
    found.mean_force += f;
    found.mean_torque += t;
    found.largest_force = std::max(found.largest_force, f);
    found.largest_torque = std::max(found.largest_torque, t);
  }
  const auto count = static_cast<double>(backbone.particles.size());
  found.mean_force /= count;
  found.mean_torque /= count;
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
  const double mu = network.springs.friction;
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
