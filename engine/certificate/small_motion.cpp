#include "engine/certificate/small_motion.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "engine/base/sphere.h"
#include "engine/certificate/modes.h"

namespace furnas {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// The generalized force on the strain e_ab of the cell when a force acts over a branch: branch_b force_a.
Eigen::Matrix<double, 6, 3> driven_by(const Vector3d& branch, bool legacy) {
  Eigen::Matrix<double, 6, 3> driven = affine(branch).transpose();
  if (!legacy) return driven;
  driven.bottomRows<3>() << 0, branch.x(), 0, 0, 0, branch.x(), 0, 0, branch.y();
  return driven;
}

/// The change of this generalized force when the branch changes and the force stays.
Eigen::Matrix<double, 6, 3> driven_over(const Vector3d& force, bool legacy) {
  Eigen::Matrix<double, 6, 3> driven;
  driven.topRows<3>() = force.asDiagonal();
  driven.bottomRows<3>() << 0, force.x(), 0, 0, 0, force.x(), 0, 0, force.y();
  if (legacy) driven.bottomRows<3>() << force.y(), 0, 0, force.z(), 0, 0, 0, force.z(), 0;
  return driven;
}

/// Assembles the matrix of all unknowns from the matrices of the bonds, with the strains that the cell is
/// free to make.
class Assembly {
 public:
  Assembly(Index particles, Index per_particle, const MatrixXd& strains)
      : per_particle_(per_particle),
        strains_(strains),
        first_strain_(particles * per_particle),
        size_(first_strain_ + strains.cols()),
        to_strain_(MatrixXd::Zero(6, first_strain_)),
        by_strain_(MatrixXd::Zero(first_strain_, 6)),
        cell_(StrainMatrix::Zero()) {}

  void add(const Bond& b, const BondMatrix& k) {
    std::array<Index, 12> at{};
    for (Index a = 0; a < 12; ++a) at[static_cast<std::size_t>(a)] = (a < 6 ? b.i : b.j) + a % 6;
    for (Index column = 0; column < 12; ++column) {
      if (column % 6 >= per_particle_) continue;
      const Index c = at[static_cast<std::size_t>(column)];
      for (Index row = 0; row < 12; ++row)
        if (row % 6 < per_particle_)
          entries_.emplace_back(at[static_cast<std::size_t>(row)], c, k(row, column));
      to_strain_.col(c) += k.block<6, 1>(12, column);
      by_strain_.row(c) += k.block<1, 6>(column, 12);
    }
    cell_ += k.block<6, 6>(12, 12);
  }
  void add(Index row, Index column, double value) { entries_.emplace_back(row, column, value); }
  StrainMatrix& cell() { return cell_; }

  SmallMotion::Sparse matrix() {
    const auto put = [&](const MatrixXd& block, Index row, Index column) {
      for (Index c = 0; c < block.cols(); ++c)
        for (Index r = 0; r < block.rows(); ++r)
          if (block(r, c) != 0) entries_.emplace_back(row + r, column + c, block(r, c));
    };
    put(strains_.transpose() * to_strain_, first_strain_, 0);
    put(by_strain_ * strains_, 0, first_strain_);
    put(strains_.transpose() * cell_ * strains_, first_strain_, first_strain_);
    SmallMotion::Sparse sum(size_, size_);
    sum.setFromTriplets(entries_.begin(), entries_.end());
    return sum;
  }

 private:
  Index per_particle_;
  const MatrixXd& strains_;
  Index first_strain_, size_;
  MatrixXd to_strain_, by_strain_;
  StrainMatrix cell_;
  std::vector<Eigen::Triplet<double>> entries_;
};

template <class Vector>
void without_mean(const VectorXd& inertia, Index particles, Index per_particle, Vector& motion) {
  for (Index axis = 0; axis < 3; ++axis) {
    const auto of = [&](auto& v) { return v(Eigen::seqN(axis, particles, per_particle)); };
    const auto mean = (of(motion).array() * of(inertia).array()).sum() / of(inertia).sum();
    of(motion).array() -= mean;
  }
}

}  // namespace

SmallMotion::SmallMotion(const ContactNetwork& network, const Backbone& backbone, const CellMotion& cell)
    : cell_(cell),
      per_particle_(network.frictional() ? 6 : 3),
      particles_(std::ssize(backbone.particles)),
      volume_(network.volume),
      friction_(network.springs.friction()),
      arms_meet_(arms_meet(network.springs.law)),
      twists_(is_synchronized(network.springs.law)) {
  bonds_ = bonds_of(network, backbone, per_particle_);
  for (const Bond& b : bonds_) limit_.push_back(b.sliding);
  bridges_ = bridges_of(bonds_, per_particle_, per_particle_ * particles_);
  const double displacement = displacement_of_strain(volume_, particles_);
  strains_ = free_strains(cell.freedom) / displacement;
  inertia_.resize(per_particle_ * particles_ + strains_.cols());
  for (Index n = 0; n < particles_; ++n) {
    const std::uint32_t k = backbone.particles[static_cast<std::size_t>(n)];
    const double mass = network.mass[k];
    const double radius = network.radius[k];
    inertia_.segment<3>(per_particle_ * n).setConstant(mass);
    if (per_particle_ == 6)
      inertia_.segment<3>(per_particle_ * n + 3)
          .setConstant(sphere_inertia(mass, radius) / (radius * radius));
  }
  inertia_.tail(strains_.cols()).setConstant(cell.inertia / (displacement * displacement));
  assemble();
}

void SmallMotion::assemble() {
  Assembly k(particles_, per_particle_, strains_);
  Assembly c(particles_, per_particle_, strains_);
  for (const Bond& b : bonds_) {
    k.add(b, elastic(b) + prestress(b, b.push, b.friction));
    c.add(b, viscous(b));
  }
  k.cell().topLeftCorner<3, 3>().array() += cell_.pressure * volume_;
  for (const Bridge& b : bridges_) {
    const double critical = 2 * std::sqrt(inertia_[b.turn]);
    for (Index row = 0; row < 3; ++row)
      for (Index column = 0; column < 3; ++column) {
        const double share = b.axis[row] * b.axis[column];
        k.add(b.turn + row, b.turn + column, share);
        c.add(b.turn + row, b.turn + column, critical * share);
      }
  }
  for (Index a = particles_ * per_particle_; a < unknowns(); ++a) c.add(a, a, cell_.drag * inertia_[a]);
  stiffness_ = k.matrix();
  damping_ = c.matrix();
}

/// Generalized forces on all unknowns of the bond by a change of the force on i.
BondMatrix SmallMotion::pull_back(const Bond& b, const BondRows& force) const {
  BondMatrix all = BondMatrix::Zero();
  all.middleRows<3>(0) = force;
  all.middleRows<3>(6) = -force;
  all.bottomRows<6>() = driven_by(b.branch, cell_.legacy) * force;
  if (per_particle_ == 3) return all;
  const BondRows couple = crossing(b.normal) * force;
  all.middleRows<3>(3) = -b.arm_i / b.radius_i * couple;
  all.middleRows<3>(9) = -b.arm_j / b.radius_j * couple;
  return all;
}

/// The relative displacement that the springs and dashpots of the contact feel.
BondRows SmallMotion::seen(const Bond& b) const {
  BondRows moved = moved_of(b.branch);
  if (!cell_.affine_velocity) moved.rightCols<6>().setZero();
  return moved;
}

BondRows SmallMotion::slip(const Bond& b) const {
  const BondRows moved = seen(b);
  return moved - b.normal * (b.normal.transpose() * moved) +
         crossing(b.normal) * (b.arm_i * turn_of(0, b.radius_i) + b.arm_j * turn_of(1, b.radius_j));
}

/// Change of F_t by a tangential spring or dashpot of strength `tangential`, while F_n changes by -`normal`
/// times the motion. If the contact slides, F_t stays at the Coulomb limit: its component along its direction
/// is mu F_n.
BondRows SmallMotion::cut(const Bond& b, const BondRow& normal, double tangential) const {
  const BondRows along_slip = slip(b);
  return -tangential * (along_slip - b.sliding * (b.sliding.transpose() * along_slip)) -
         friction_ * b.sliding * normal;
}

BondMatrix SmallMotion::elastic(const Bond& b) const {
  const BondRow normal = b.normal_stiffness * b.normal.transpose() * moved_of(b.branch);
  BondRows force = -b.normal * normal;
  if (per_particle_ == 6) force += cut(b, normal, b.tangential_stiffness);
  return -pull_back(b, force);
}

BondMatrix SmallMotion::viscous(const Bond& b) const {
  const BondRow normal = b.normal_damping * b.normal.transpose() * seen(b);
  BondRows force = -b.normal * normal;
  if (per_particle_ == 6) force += cut(b, normal, b.tangential_damping);
  return -pull_back(b, force);
}

BondMatrix SmallMotion::prestress(const Bond& b, double push, const Vector3d& friction) const {
  const BondRows moved = moved_of(b.branch);
  const BondRow stretch = b.normal.transpose() * moved;
  const BondRows tilt = (moved - b.normal * stretch) / b.branch.norm();
  const Vector3d whole = push * b.normal + friction;
  BondRows force = push * tilt;
  if (per_particle_ == 6) force -= b.normal * (friction.transpose() * tilt);
  if (twists_ && per_particle_ == 6)
    force += 0.5 * b.normal.cross(friction) *
             (b.normal.transpose() * (turn_of(0, b.radius_i) + turn_of(1, b.radius_j)));
  BondMatrix all = pull_back(b, force);
  // The forces stay; the branches and lever arms change.
  all.bottomRows<6>() += driven_over(whole, cell_.legacy) * moved;
  if (per_particle_ == 3) return -all;
  const BondRows lengthening = (arms_meet_ ? 0.5 : 0) * b.normal.cross(friction) * stretch;
  const BondRows turned = crossing(whole) * tilt;
  all.middleRows<3>(3) -= (lengthening - b.arm_i * turned) / b.radius_i;
  all.middleRows<3>(9) -= (lengthening - b.arm_j * turned) / b.radius_j;
  return -all;
}

void SmallMotion::hold_centre(Eigen::Ref<Eigen::VectorXcd> motion) const {
  without_mean(inertia_, particles_, per_particle_, motion);
}
void SmallMotion::hold_centre(Eigen::Ref<VectorXd> motion) const {
  without_mean(inertia_, particles_, per_particle_, motion);
}

bool SmallMotion::slides() const {
  return std::any_of(bonds_.begin(), bonds_.end(), [](const Bond& b) { return !b.sliding.isZero(); });
}

VectorXd SmallMotion::loading(const VectorXd& motion, double lambda) const {
  VectorXd loading = VectorXd::Zero(std::ssize(bonds_));
  if (per_particle_ == 3) return loading;
  for (std::size_t n = 0; n < bonds_.size(); ++n) {
    const Bond& b = bonds_[n];
    BondVector z;
    z << motion.segment<6>(b.i), motion.segment<6>(b.j), strains_ * motion.tail(strains_.cols());
    const double tangential = b.tangential_stiffness + lambda * b.tangential_damping;
    const double of_limit = b.normal_stiffness * b.normal.dot(moved_of(b.branch) * z) +
                            lambda * b.normal_damping * b.normal.dot(seen(b) * z);
    // Slip against the direction of F_t stretches the spring. Separation of the spheres lowers the limit mu
    // F_n.
    if (!limit_[n].isZero())
      loading[static_cast<Index>(n)] = friction_ * of_limit - tangential * limit_[n].dot(slip(b) * z);
  }
  return loading;
}

SmallMotion SmallMotion::sliding_where(const VectorXd& loading) const {
  SmallMotion other = *this;
  for (std::size_t n = 0; n < bonds_.size(); ++n)
    other.bonds_[n].sliding = loading[static_cast<Index>(n)] > 0 ? limit_[n] : Vector3d::Zero();
  other.assemble();
  return other;
}

double SmallMotion::doubt(const Eigen::VectorXcd& left, const Eigen::VectorXcd& right) const {
  const auto of_bond = [&](const Bond& b, const Eigen::VectorXcd& motion) {
    Eigen::Matrix<std::complex<double>, 18, 1> v = Eigen::Matrix<std::complex<double>, 18, 1>::Zero();
    v.segment(0, per_particle_) = motion.segment(b.i, per_particle_);
    v.segment(6, per_particle_) = motion.segment(b.j, per_particle_);
    v.tail<6>() = strains_ * motion.tail(strains_.cols());
    return v;
  };
  double sum = 0;
  for (const Bond& b : bonds_) {
    const auto l = of_bond(b, left);
    const auto r = of_bond(b, right);
    const auto work = [&](double push, const Vector3d& friction) {
      return std::abs(l.dot(prestress(b, push, friction) * r));
    };
    const Vector3d across = b.normal.unitOrthogonal();
    sum +=
        b.lacking * std::hypot(work(1, Vector3d::Zero()), work(0, across), work(0, b.normal.cross(across)));
  }
  return sum;
}

}  // namespace furnas
