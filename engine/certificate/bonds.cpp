#include "engine/certificate/bonds.h"

#include <Eigen/Geometry>

#include "engine/certificate/statics.h"

namespace furnas {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Vector3d;

Vector3d wide(const Vec3<double>& v) { return {v.x, v.y, v.z}; }

}  // namespace

std::vector<Bond> bonds_of(const ContactNetwork& network, const Backbone& backbone, Index per_particle) {
  std::vector<Index> first(backbone.contains.size());
  for (std::size_t n = 0; n < backbone.particles.size(); ++n)
    first[backbone.particles[n]] = per_particle * static_cast<Index>(n);
  const std::vector<Residual> residual = residuals(network);
  const auto lacking = [&](std::uint32_t k) {
    return norm(residual[k].force) + norm(residual[k].torque) / network.radius[k];
  };
  std::vector<Bond> bonds;
  for (const StaticContact* c : backbone.bonds) {
    const Vector3d friction = wide(c->tangential_force);
    bonds.push_back({.i = first[c->i],
                     .j = first[c->j],
                     .branch = wide(c->branch),
                     .normal = wide(c->normal),
                     .friction = friction,
                     .sliding = c->sliding ? friction.normalized() : Vector3d::Zero(),
                     .push = c->normal_force,
                     .normal_stiffness = c->normal_stiffness,
                     .tangential_stiffness = c->tangential_stiffness,
                     .normal_damping = c->normal_damping,
                     .tangential_damping = c->tangential_damping,
                     .lacking = lacking(c->i) + lacking(c->j),
                     .arm_i = c->arm_i,
                     .arm_j = c->arm_j,
                     .radius_i = network.radius[c->i],
                     .radius_j = network.radius[c->j]});
  }
  return bonds;
}

std::vector<Bridge> bridges_of(const std::vector<Bond>& bonds, Index per_particle, Index unknowns) {
  std::vector<Bridge> bridges;
  if (per_particle == 3) return bridges;
  // Contact points of each particle, relative to its centre.
  std::vector<std::vector<Vector3d>> points(static_cast<std::size_t>(unknowns / per_particle));
  for (const Bond& b : bonds) {
    points[static_cast<std::size_t>(b.i / per_particle)].emplace_back(-b.arm_i * b.normal);
    points[static_cast<std::size_t>(b.j / per_particle)].emplace_back(b.arm_j * b.normal);
  }
  for (std::size_t k = 0; k < points.size(); ++k)
    if (points[k].size() == 2)
      bridges.push_back(
          {static_cast<Index>(k) * per_particle + 3, (points[k][1] - points[k][0]).normalized()});
  return bridges;
}

Matrix3d crossing(const Vector3d& n) {
  Matrix3d x;
  x << 0, -n.z(), n.y(), n.z(), 0, -n.x(), -n.y(), n.x(), 0;
  return x;
}

Eigen::Matrix<double, 3, 6> affine(const Vector3d& r) {
  Eigen::Matrix<double, 3, 6> g;
  g << r.x(), 0, 0, r.y(), r.z(), 0,  //
      0, r.y(), 0, 0, 0, r.z(),       //
      0, 0, r.z(), 0, 0, 0;
  return g;
}

BondRows moved_of(const Vector3d& branch) {
  BondRows moved = BondRows::Zero();
  moved.block<3, 3>(0, 0).setIdentity();
  moved.block<3, 3>(0, 6) = -Matrix3d::Identity();
  moved.block<3, 6>(0, 12) = affine(branch);
  return moved;
}

BondRows turn_of(Index which, double radius) {
  BondRows turn = BondRows::Zero();
  turn.block<3, 3>(0, 3 + 6 * which) = Matrix3d::Identity() / radius;
  return turn;
}

}  // namespace furnas
