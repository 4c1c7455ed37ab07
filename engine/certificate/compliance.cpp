#include "engine/certificate/compliance.h"

#include <Eigen/CholmodSupport>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/SparseCholesky>

#include "engine/base/require.h"

namespace furnas {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Sparse = Eigen::SparseMatrix<double>;

constexpr Index held = 3;  // the translation of the first particle

/// Takes the mean displacement out.
MatrixXd without_translation(MatrixXd motion, Index per_particle) {
  const Index count = motion.rows() / per_particle;
  for (Index column = 0; column < motion.cols(); ++column) {
    Eigen::Map<MatrixXd> particles(motion.col(column).data(), per_particle, count);
    particles.topRows<3>().colwise() -= particles.topRows<3>().rowwise().mean().eval();
  }
  return motion;
}

}  // namespace

/// L L^T by CHOLMOD, an order of magnitude faster than any L D L^T; that by Eigen for what is not definite.
class Compliance::Factor {
 public:
  explicit Factor(const Sparse& matrix) {
    definite_.cholmod().print = 0;
    definite_.compute(matrix);
    if (definite_.info() == Eigen::Success) return;
    indefinite_ = std::make_unique<Eigen::SimplicialLDLT<Sparse>>(matrix);
  }
  bool valid() const {
    return !indefinite_ || (indefinite_->info() == Eigen::Success && indefinite_->vectorD().allFinite());
  }
  Index negative() const { return indefinite_ ? (indefinite_->vectorD().array() < 0).count() : 0; }
  MatrixXd solve(const MatrixXd& b) const {
    if (indefinite_) return indefinite_->solve(b);
    return definite_.solve(b);
  }

 private:
  Eigen::CholmodSupernodalLLT<Sparse> definite_;
  std::unique_ptr<Eigen::SimplicialLDLT<Sparse>> indefinite_;
};

Compliance::Compliance(const Stiffness& stiffness, MatrixXd strains)
    : unknowns_(stiffness.unknowns()), per_particle_(stiffness.per_particle()), strains_(std::move(strains)) {
  require(unknowns_ >= 2 * per_particle_, "two particles at least");
  const Sparse all = stiffness.among_particles();
  factor_ = std::make_unique<Factor>(all.bottomRightCorner(unknowns_ - held, unknowns_ - held));
  valid_ = factor_->valid();
  if (!valid_) return;
  negative_ = factor_->negative();

  const MatrixXd coupling = stiffness.particles_by_strain();
  const MatrixXd answer = particles_follow(coupling);
  relaxed_ = stiffness.among_strains() - coupling.transpose() * answer;
  relaxed_ = (0.5 * (relaxed_ + relaxed_.transpose())).eval();
  if (strains_.cols() > 0) {
    answer_ = answer * strains_;
    const MatrixXd schur = strains_.transpose() * relaxed_ * strains_;
    negative_ += (Eigen::SelfAdjointEigenSolver<MatrixXd>(schur).eigenvalues().array() < 0).count();
    schur_ = schur.inverse();
  }
  valid_ = relaxed_.allFinite() && schur_.allFinite();
}

Compliance::~Compliance() = default;

MatrixXd Compliance::particles_follow(const MatrixXd& forces) const {
  const MatrixXd balanced = without_translation(forces, per_particle_);
  MatrixXd motion = MatrixXd::Zero(forces.rows(), forces.cols());
  motion.bottomRows(unknowns_ - held) = factor_->solve(balanced.bottomRows(unknowns_ - held));
  return without_translation(std::move(motion), per_particle_);
}

Index Compliance::rows() const { return unknowns_ + strains_.cols(); }

void Compliance::set_shift(double shift) const { require(shift == 0, "factored without a shift"); }

void Compliance::perform_op(const double* in, double* out) const {
  const Index m = strains_.cols();
  const Eigen::Map<const Eigen::VectorXd> load(in, unknowns_ + m);
  Eigen::Map<Eigen::VectorXd> motion(out, unknowns_ + m);
  const MatrixXd forces = without_translation(load.head(unknowns_), per_particle_);
  motion.head(unknowns_) = particles_follow(forces);
  if (m == 0) return;
  motion.tail(m) = schur_ * (load.tail(m) - answer_.transpose() * forces);
  motion.head(unknowns_) -= answer_ * motion.tail(m);
}

}  // namespace furnas
