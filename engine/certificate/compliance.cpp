#include "engine/certificate/compliance.h"

#include <Eigen/CholmodSupport>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <new>
#include <string>
#include <vector>

#include "engine/base/require.h"

namespace furnas {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Sparse = Eigen::SparseMatrix<double>;

constexpr Index held = 3;  // unknowns that are fixed: the displacement of the first particle

/// Subtracts the mean displacement.
MatrixXd without_translation(MatrixXd motion, Index per_particle) {
  const Index count = motion.rows() / per_particle;
  for (Index column = 0; column < motion.cols(); ++column) {
    Eigen::Map<MatrixXd> particles(motion.col(column).data(), per_particle, count);
    particles.topRows<3>().colwise() -= particles.topRows<3>().rowwise().mean().eval();
  }
  return motion;
}

}  // namespace

/// L L^T by CHOLMOD, an order of magnitude faster than any L D L^T. If CHOLMOD meets a pivot that is not
/// positive, springs of 1 k_n, called holds, are added to the unknowns of this particle, or of its neighbours
/// if it has holds already, and the factorization begins again. Let B B^T be the sum of the holds. Then the
/// matrix A has as many negative eigenvalues as the small matrix 1 - B^T (A + B B^T)^-1 B (Haynsworth's
/// inertia additivity), and Woodbury's identity gives the inverse of A from that of A + B B^T. If this
/// happens too often, Eigen factors A as L D L^T.
class Compliance::Factor {
 public:
  /// The unknowns of the first particle lack those that are fixed.
  Factor(const Sparse& matrix, Index per_particle)
      : per_particle_(per_particle),
        has_hold_(Eigen::Array<bool, Eigen::Dynamic, 1>::Constant(matrix.rows(), false)) {
    Sparse with_holds = matrix;
    definite_.cholmod().print = 0;
    definite_.analyze(with_holds);
    for (int refused = 0; !definite_.factor(with_holds); ++refused) {
      if (refused == most_refused) {
        indefinite_ = std::make_unique<Eigen::SimplicialLDLT<Sparse>>(matrix);
        return;
      }
      hold(definite_.stopped_at(), with_holds);
    }
    take_back();
  }
  bool valid() const {
    if (indefinite_) return indefinite_->info() == Eigen::Success && indefinite_->vectorD().allFinite();
    return answers_.allFinite() && rest_.allFinite();
  }
  Index negative() const {
    if (indefinite_) return (indefinite_->vectorD().array() < 0).count();
    if (held_.empty()) return 0;
    return (Eigen::SelfAdjointEigenSolver<MatrixXd>(rest_).eigenvalues().array() < 0).count();
  }
  MatrixXd solve(const MatrixXd& b) const {
    if (indefinite_) return indefinite_->solve(b);
    MatrixXd x = definite_.solve(b);
    if (!held_.empty()) x += answers_ * rest_.partialPivLu().solve(at_holds(x));
    return x;
  }

 private:
  static constexpr int most_refused = 40;

  /// A Cholesky factorization that also reports the column at which it stopped, and what CHOLMOD cannot do.
  /// Eigen reports success for a factor that CHOLMOD had no memory for.
  struct Cholesky : Eigen::CholmodSupernodalLLT<Sparse> {
    void analyze(const Sparse& matrix) {
      analyzePattern(matrix);
      check(matrix.rows());
    }
    /// False if a pivot is not positive.
    bool factor(const Sparse& matrix) {
      factorize(matrix);
      check(matrix.rows());
      return info() == Eigen::Success;
    }
    Index stopped_at() const {
      return static_cast<const int*>(m_cholmodFactor->Perm)[m_cholmodFactor->minor];
    }

   private:
    /// Throws std::bad_alloc without memory, and InputError for a matrix that CHOLMOD cannot factor.
    void check(Index rows) {
      const int status = cholmod().status;
      if (status == CHOLMOD_OUT_OF_MEMORY) throw std::bad_alloc();
      if (status < CHOLMOD_OK || m_cholmodFactor == nullptr)
        throw InputError(
            "the stiffness matrix of " + std::to_string(rows) +
            " unknowns is too large for CHOLMOD, which counts the entries of a factor in 32 bits");
    }
  };

  /// The unknowns of the particle to which this one belongs begin here.
  Index first_of(Index unknown) const {
    return std::max<Index>((unknown + held) / per_particle_ * per_particle_ - held, 0);
  }

  void hold_particle(Index unknown, Sparse& matrix) {
    const Index first = first_of(unknown);
    for (Index k = first; k < matrix.rows() && first_of(k) == first && !has_hold_[k]; ++k) {
      matrix.coeffRef(k, k) += 1;
      has_hold_[k] = true;
      held_.push_back(k);
    }
  }

  void hold(Index unknown, Sparse& matrix) {
    if (!has_hold_[unknown]) return hold_particle(unknown, matrix);
    for (Sparse::InnerIterator entry(matrix, unknown); entry; ++entry) hold_particle(entry.row(), matrix);
  }

  MatrixXd at_holds(const MatrixXd& x) const { return x(held_, Eigen::all); }

  void take_back() {
    const auto holds = static_cast<Index>(held_.size());
    MatrixXd forces = MatrixXd::Zero(definite_.rows(), holds);
    for (Index k = 0; k < holds; ++k) forces(held_[static_cast<std::size_t>(k)], k) = 1;
    answers_ = definite_.solve(forces);
    rest_ = MatrixXd::Identity(holds, holds) - at_holds(answers_);
    rest_ = (0.5 * (rest_ + rest_.transpose())).eval();
  }

  Index per_particle_;
  Eigen::Array<bool, Eigen::Dynamic, 1> has_hold_;
  Cholesky definite_;
  std::vector<Index> held_;  // unknowns with a hold
  MatrixXd answers_;         // displacements of all unknowns by a force on each hold
  MatrixXd rest_;            // 1 - B^T (A + B B^T)^-1 B
  std::unique_ptr<Eigen::SimplicialLDLT<Sparse>> indefinite_;
};

Compliance::Compliance(const Stiffness& stiffness, MatrixXd strains)
    : unknowns_(stiffness.unknowns()), per_particle_(stiffness.per_particle()), strains_(std::move(strains)) {
  require(unknowns_ >= 2 * per_particle_, "two particles at least");
  const Sparse all = stiffness.among_particles();
  factor_ =
      std::make_unique<Factor>(all.bottomRightCorner(unknowns_ - held, unknowns_ - held), per_particle_);
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
