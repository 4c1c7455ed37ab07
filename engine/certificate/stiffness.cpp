#include "engine/certificate/stiffness.h"

#include <Eigen/Geometry>
#include <cmath>

namespace furnas {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Vector3d;

}  // namespace

Stiffness::Stiffness(const ContactNetwork& network, const Backbone& backbone, double pressure)
    : per_particle_(network.frictional() ? 6 : 3),
      unknowns_(per_particle_ * static_cast<Index>(backbone.particles.size())),
      volume_(network.volume),
      pressure_(pressure),
      arms_meet_(arms_meet(network.springs.law)),
      twists_(is_synchronized(network.springs.law)) {
  bonds_ = bonds_of(network, backbone, per_particle_);
  bridges_ = bridges_of(bonds_, per_particle_, unknowns_);
}

BondMatrix Stiffness::elastic(const Bond& b) const {
  const BondRows moved = moved_of(b.branch);
  const Matrix3d along = b.normal * b.normal.transpose();
  BondMatrix k = b.normal_stiffness * (moved.transpose() * along * moved);
  if (per_particle_ == 3) return k;
  const BondRows slip =
      (Matrix3d::Identity() - along) * moved +
      crossing(b.normal) * (b.arm_i * turn_of(0, b.radius_i) + b.arm_j * turn_of(1, b.radius_j));
  const Matrix3d held = b.tangential_stiffness * (Matrix3d::Identity() - b.sliding * b.sliding.transpose());
  return k + slip.transpose() * held * slip;
}

BondMatrix Stiffness::prestress(const Bond& b, double push, const Vector3d& friction) const {
  const BondRows moved = moved_of(b.branch);
  const BondRows tilt = (moved - b.normal * (b.normal.transpose() * moved)) / b.branch.norm();
  BondMatrix k = -push * b.branch.norm() * tilt.transpose() * tilt;
  if (per_particle_ == 3) return k;

  // F_t turns with the normal and, under most laws, with the spheres about the normal; so do its torques.
  const BondRows turn_i = turn_of(0, b.radius_i);
  const BondRows turn_j = turn_of(1, b.radius_j);
  const BondRow stretch = b.normal.transpose() * moved;
  const BondRow twist = (twists_ ? 0.5 : 0) * b.normal.transpose() * (turn_i + turn_j);
  const Vector3d couple = b.normal.cross(friction);
  const double lengthening = arms_meet_ ? 0.5 : 0;  // change of a lever arm per change of the distance
  const BondRows arms = b.arm_i * turn_i + b.arm_j * turn_j;
  const BondMatrix turned =
      tilt.transpose() * friction * stretch - twist.transpose() * couple.transpose() * moved +
      lengthening * (turn_i + turn_j).transpose() * couple * stretch -
      arms.transpose() * crossing(friction) * tilt - arms.transpose() * friction * twist;
  return k + 0.5 * (turned + turned.transpose());
}

BondMatrix Stiffness::local(const Bond& b) const { return elastic(b) + prestress(b, b.push, b.friction); }

BondVector Stiffness::of_bond(const Bond& b, const Motion& motion) const {
  BondVector v = BondVector::Zero();
  v.segment(0, per_particle_) = motion.particles.segment(b.i, per_particle_);
  v.segment(6, per_particle_) = motion.particles.segment(b.j, per_particle_);
  v.tail<6>() = motion.strain;
  return v;
}

Stiffness::Motion Stiffness::times(const Motion& motion) const {
  Motion answer{Eigen::VectorXd::Zero(unknowns_), of_volume() * motion.strain};
  for (const Bond& b : bonds_) {
    const BondVector force = local(b) * of_bond(b, motion);
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
    const BondVector v = of_bond(b, motion);
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
    const BondMatrix k = local(b);
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
    const BondMatrix k = local(b);
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
