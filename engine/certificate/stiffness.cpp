#include "engine/certificate/stiffness.h"

#include <Eigen/Geometry>
#include <cmath>

#include "engine/certificate/statics.h"

namespace furnas {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using Row = Eigen::Matrix<double, 1, 18>;
using Rows = Eigen::Matrix<double, 3, 18>;

Vector3d wide(const Vec3<double>& v) { return {v.x, v.y, v.z}; }

/// n x, as a matrix.
Matrix3d crossing(const Vector3d& n) {
  Matrix3d x;
  x << 0, -n.z(), n.y(), n.z(), 0, -n.x(), -n.y(), n.x(), 0;
  return x;
}

/// e r as a matrix that acts on the six strains.
Eigen::Matrix<double, 3, 6> affine(const Vector3d& r) {
  Eigen::Matrix<double, 3, 6> g;
  g << r.x(), 0, 0, r.y(), r.z(), 0,  //
      0, r.y(), 0, 0, 0, r.z(),       //
      0, 0, r.z(), 0, 0, 0;
  return g;
}

/// How i moves against j.
Rows moved_of(const Vector3d& branch) {
  Rows moved = Rows::Zero();
  moved.block<3, 3>(0, 0).setIdentity();
  moved.block<3, 3>(0, 6) = -Matrix3d::Identity();
  moved.block<3, 6>(0, 12) = affine(branch);
  return moved;
}

/// How i (0) or j (1) turns.
Rows turn_of(Index which, double radius) {
  Rows turn = Rows::Zero();
  turn.block<3, 3>(0, 3 + 6 * which) = Matrix3d::Identity() / radius;
  return turn;
}

}  // namespace

Stiffness::Stiffness(const ContactNetwork& network, const Backbone& backbone, double pressure)
    : per_particle_(network.frictional() ? 6 : 3),
      unknowns_(per_particle_ * static_cast<Index>(backbone.particles.size())),
      volume_(network.volume),
      pressure_(pressure),
      arms_meet_(arms_meet(network.springs.law)) {
  std::vector<Index> first(backbone.contains.size());
  for (std::size_t n = 0; n < backbone.particles.size(); ++n)
    first[backbone.particles[n]] = per_particle_ * static_cast<Index>(n);
  const std::vector<Residual> residual = residuals(network);
  const auto lacking = [&](std::uint32_t k) {
    return norm(residual[k].force) + norm(residual[k].torque) / network.radius[k];
  };
  for (const StaticContact* c : backbone.bonds) {
    const Vector3d friction = wide(c->tangential_force);
    bonds_.push_back({.i = first[c->i],
                      .j = first[c->j],
                      .branch = wide(c->branch),
                      .normal = wide(c->normal),
                      .friction = friction,
                      .sliding = c->sliding ? friction.normalized() : Vector3d::Zero(),
                      .push = c->normal_force,
                      .normal_stiffness = c->normal_stiffness,
                      .tangential_stiffness = c->tangential_stiffness,
                      .lacking = lacking(c->i) + lacking(c->j),
                      .arm_i = c->arm_i,
                      .arm_j = c->arm_j,
                      .radius_i = network.radius[c->i],
                      .radius_j = network.radius[c->j]});
  }
  if (network.frictional()) find_bridges(backbone);
}

void Stiffness::find_bridges(const Backbone& backbone) {
  std::vector<std::vector<Vector3d>> points(backbone.particles.size());  // of contact, from the centre
  for (const Bond& b : bonds_) {
    points[static_cast<std::size_t>(b.i / per_particle_)].emplace_back(-b.arm_i * b.normal);
    points[static_cast<std::size_t>(b.j / per_particle_)].emplace_back(b.arm_j * b.normal);
  }
  for (std::size_t k = 0; k < points.size(); ++k)
    if (points[k].size() == 2)
      bridges_.push_back(
          {static_cast<Index>(k) * per_particle_ + 3, (points[k][1] - points[k][0]).normalized()});
}

Stiffness::Local Stiffness::elastic(const Bond& b) const {
  const Rows moved = moved_of(b.branch);
  const Matrix3d along = b.normal * b.normal.transpose();
  Local k = b.normal_stiffness * (moved.transpose() * along * moved);
  if (per_particle_ == 3) return k;
  const Rows slip =
      (Matrix3d::Identity() - along) * moved +
      crossing(b.normal) * (b.arm_i * turn_of(0, b.radius_i) + b.arm_j * turn_of(1, b.radius_j));
  const Matrix3d held = b.tangential_stiffness * (Matrix3d::Identity() - b.sliding * b.sliding.transpose());
  return k + slip.transpose() * held * slip;
}

Stiffness::Local Stiffness::prestress(const Bond& b, double push, const Vector3d& friction) const {
  const Rows moved = moved_of(b.branch);
  const Rows tilt = (moved - b.normal * (b.normal.transpose() * moved)) / b.branch.norm();
  Local k = -push * b.branch.norm() * tilt.transpose() * tilt;
  if (per_particle_ == 3) return k;

  // Friction turns with the normal and with the spheres about it, and so do its torques.
  const Rows turn_i = turn_of(0, b.radius_i);
  const Rows turn_j = turn_of(1, b.radius_j);
  const Row stretch = b.normal.transpose() * moved;
  const Row twist = 0.5 * b.normal.transpose() * (turn_i + turn_j);
  const Vector3d couple = b.normal.cross(friction);
  const double lengthening = arms_meet_ ? 0.5 : 0;  // of an arm with the distance
  const Rows arms = b.arm_i * turn_i + b.arm_j * turn_j;
  const Local turned = tilt.transpose() * friction * stretch -
                       twist.transpose() * couple.transpose() * moved +
                       lengthening * (turn_i + turn_j).transpose() * couple * stretch -
                       arms.transpose() * crossing(friction) * tilt - arms.transpose() * friction * twist;
  return k + 0.5 * (turned + turned.transpose());
}

Stiffness::Local Stiffness::local(const Bond& b) const {
  return elastic(b) + prestress(b, b.push, b.friction);
}

Stiffness::Vector Stiffness::of_bond(const Bond& b, const Motion& motion) const {
  Vector v = Vector::Zero();
  v.segment(0, per_particle_) = motion.particles.segment(b.i, per_particle_);
  v.segment(6, per_particle_) = motion.particles.segment(b.j, per_particle_);
  v.tail<6>() = motion.strain;
  return v;
}

Stiffness::Motion Stiffness::times(const Motion& motion) const {
  Motion answer{Eigen::VectorXd::Zero(unknowns_), of_volume() * motion.strain};
  for (const Bond& b : bonds_) {
    const Vector force = local(b) * of_bond(b, motion);
    answer.particles.segment(b.i, per_particle_) += force.segment(0, per_particle_);
    answer.particles.segment(b.j, per_particle_) += force.segment(6, per_particle_);
    answer.strain += force.tail<6>();
  }
  for (const Bridge& b : bridges_)
    answer.particles.segment<3>(b.turn) += b.axis.dot(motion.particles.segment<3>(b.turn)) * b.axis;
  return answer;
}

double Stiffness::doubt(const Motion& motion) const {
  double sum = 0;
  for (const Bond& b : bonds_) {
    const Vector v = of_bond(b, motion);
    const auto energy = [&](double push, const Vector3d& friction) -> double {
      return v.dot(prestress(b, push, friction) * v);
    };
    const Vector3d across = b.normal.unitOrthogonal();
    sum += b.lacking *
           std::hypot(energy(1, Vector3d::Zero()), energy(0, across), energy(0, b.normal.cross(across)));
  }
  return sum;
}

std::array<Index, 12> Stiffness::places(const Bond& b) const {
  std::array<Index, 12> at{};
  for (Index a = 0; a < per_particle_; ++a) {
    at[static_cast<std::size_t>(a)] = b.i + a;
    at[static_cast<std::size_t>(a + 6)] = b.j + a;
  }
  return at;
}

Eigen::SparseMatrix<double> Stiffness::among_particles() const {
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(bonds_.size() *
                  static_cast<std::size_t>(2 * per_particle_ * per_particle_ + per_particle_));
  for (const Bond& b : bonds_) {
    const Local k = local(b);
    const auto at = places(b);
    for (Index row = 0; row < 12; ++row)
      for (Index column = 0; column < 12; ++column) {
        if (row % 6 >= per_particle_ || column % 6 >= per_particle_) continue;
        const Index r = at[static_cast<std::size_t>(row)];
        const Index c = at[static_cast<std::size_t>(column)];
        if (r >= c) entries.emplace_back(r, c, k(row, column));
      }
  }
  for (const Bridge& b : bridges_)
    for (Index row = 0; row < 3; ++row)
      for (Index column = 0; column <= row; ++column)
        entries.emplace_back(b.turn + row, b.turn + column, b.axis[row] * b.axis[column]);
  Eigen::SparseMatrix<double> matrix(unknowns_, unknowns_);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

Eigen::MatrixXd Stiffness::particles_by_strain() const {
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(unknowns_, 6);
  for (const Bond& b : bonds_) {
    const Local k = local(b);
    const auto at = places(b);
    for (Index row = 0; row < 12; ++row)
      if (row % 6 < per_particle_) matrix.row(at[static_cast<std::size_t>(row)]) += k.block<1, 6>(row, 12);
  }
  return matrix;
}

StrainMatrix Stiffness::among_strains() const {
  StrainMatrix matrix = of_volume();
  for (const Bond& b : bonds_) matrix += local(b).block<6, 6>(12, 12);
  return matrix;
}

StrainMatrix Stiffness::of_volume() const {
  // det(1 + e) = 1 + tr e + sum over a < b of e_aa e_bb + ..., e upper-triangular.
  StrainMatrix matrix = StrainMatrix::Zero();
  for (Index a = 0; a < 3; ++a)
    for (Index b = 0; b < 3; ++b)
      if (a != b) matrix(a, b) = pressure_ * volume_;
  return matrix;
}

}  // namespace furnas
