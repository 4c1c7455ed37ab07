#include "engine/certificate/growth.h"

#include <Eigen/Eigenvalues>
#include <Eigen/UmfPackSupport>
#include <algorithm>
#include <cmath>
#include <optional>
#include <type_traits>

#include "engine/base/random.h"
#include "engine/certificate/modes.h"

namespace furnas {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

/// Slower growth counts as none [1/time].
constexpr double least_rate = 1e-6;

/// M lambda^2 + C lambda + K.
template <class Number>
Eigen::SparseMatrix<Number> at(const SmallMotion& motion, Number lambda) {
  Eigen::SparseMatrix<Number> sum =
      motion.stiffness().cast<Number>() + lambda * motion.damping().cast<Number>();
  for (Index k = 0; k < motion.unknowns(); ++k) sum.coeffRef(k, k) += lambda * lambda * motion.inertia()[k];
  sum.makeCompressed();
  return sum;
}

/// Factors L U of this matrix, by UMFPACK.
template <class Number>
class Factor : private Eigen::UmfPackLU<Eigen::SparseMatrix<Number>> {
 public:
  using Vector = Eigen::Matrix<Number, Eigen::Dynamic, 1>;

  Factor(const SmallMotion& motion, Number lambda) : matrix_(at(motion, lambda)) {
    this->umfpackControl()[UMFPACK_STRATEGY] = UMFPACK_STRATEGY_SYMMETRIC;  // of the pattern
    this->compute(matrix_);
  }
  bool valid() const { return this->info() == Eigen::Success; }
  Vector solve(const Vector& b) const { return solved(UMFPACK_A, b); }
  /// Solves with the transposed, conjugated matrix.
  Vector solve_adjoint(const Vector& b) const { return solved(UMFPACK_At, b); }

 private:
  Vector solved(int system, const Vector& b) const {
    Vector x(b.size());
    Eigen::umfpack_solve(system, matrix_.outerIndexPtr(), matrix_.innerIndexPtr(), matrix_.valuePtr(),
                         x.data(), b.data(), this->m_numeric, this->m_control.data(),
                         this->m_umfpackInfo.data());
    return x;
  }
  Eigen::SparseMatrix<Number> matrix_;
};

/// (A - sigma)^-1 acting on motions and their rates, x' = A x, without translations of the whole packing.
/// Motions are multiplied by the root of the inertia, and rates by the root of the inertia divided by sigma.
/// Both then have similar sizes.
class Shifted {
 public:
  Shifted(const SmallMotion& motion, double sigma)
      : motion_(motion), sigma_(sigma), root_(motion.inertia().cwiseSqrt()), factor_(motion, sigma) {}
  bool valid() const { return factor_.valid(); }
  VectorXd operator()(const VectorXd& x) const {
    const Index n = motion_.unknowns();
    VectorXd a = x.head(n).cwiseQuotient(root_);
    VectorXd b = sigma_ * x.tail(n).cwiseQuotient(root_);
    motion_.hold_centre(a);
    motion_.hold_centre(b);
    VectorXd z = -factor_.solve(motion_.inertia().cwiseProduct(b + sigma_ * a) + motion_.damping() * a);
    motion_.hold_centre(z);
    VectorXd out(2 * n);
    out << root_.cwiseProduct(z), root_.cwiseProduct(a + sigma_ * z) / sigma_;
    return out;
  }
  /// The displacements in such a vector.
  VectorXcd displacements(const VectorXcd& x) const {
    return x.head(motion_.unknowns()).cwiseQuotient(root_);
  }

 private:
  const SmallMotion& motion_;
  double sigma_;
  VectorXd root_;
  Factor<double> factor_;
};

VectorXd random_motion(Index size, std::uint64_t seed) {
  VectorXd v(size);
  for (Index k = 0; k < size; ++k)
    v[k] = static_cast<double>(philox({static_cast<std::uint32_t>(k), 0, 0, 0}, seed)[0]) * 0x1p-31 - 1;
  return v;
}

struct Ritz {
  Complex lambda;
  double error;  // of lambda
  VectorXcd motion;
};

/// Eigenvalues near sigma, and with a real part above `above`, from a Krylov space of `size` vectors.
std::vector<Ritz> arnoldi(const SmallMotion& motion, double sigma, Index size, double above, bool& valid) {
  const Shifted apply(motion, sigma);
  valid = apply.valid();
  if (!valid) return {};
  const Index rows = 2 * motion.unknowns();
  size = std::min(size, rows - 6);
  MatrixXd basis(rows, size + 1);
  MatrixXd h = MatrixXd::Zero(size + 1, size);
  basis.col(0) = apply(random_motion(rows, 1)).normalized();
  Index count = 0;
  for (Index k = 0; k < size; ++k, ++count) {
    VectorXd next = apply(basis.col(k));
    const double whole = next.norm();
    for (int twice = 0; twice < 2; ++twice) {
      const VectorXd along = basis.leftCols(k + 1).transpose() * next;
      h.col(k).head(k + 1) += along;
      next -= basis.leftCols(k + 1) * along;
    }
    h(k + 1, k) = next.norm();
    if (h(k + 1, k) < 1e-14 * whole) {
      ++count;
      break;
    }
    basis.col(k + 1) = next / h(k + 1, k);
  }
  const Eigen::EigenSolver<MatrixXd> spectrum(h.topLeftCorner(count, count));
  valid = spectrum.info() == Eigen::Success;
  if (!valid) return {};
  std::vector<Ritz> found;
  for (Index k = 0; k < count; ++k) {
    const Complex theta = spectrum.eigenvalues()[k];
    const Complex lambda = sigma + 1.0 / theta;
    if (!(lambda.real() > above) || lambda.imag() < 0) continue;
    const VectorXcd s = spectrum.eigenvectors().col(k).normalized();
    const double error = std::abs(h(count, count - 1) * s[count - 1]) / std::norm(theta);
    found.push_back({lambda, error, apply.displacements(basis.leftCols(count) * s)});
  }
  return found;
}

/// All eigenvalues with a real part above `above`, for few unknowns.
std::vector<Ritz> dense(const SmallMotion& motion, double above, bool& valid) {
  const Index n = motion.unknowns();
  MatrixXd a = MatrixXd::Zero(2 * n, 2 * n);
  a.topRightCorner(n, n).setIdentity();
  const VectorXd faster = -motion.inertia().cwiseInverse();
  a.bottomLeftCorner(n, n) = faster.asDiagonal() * MatrixXd(motion.stiffness());
  a.bottomRightCorner(n, n) = faster.asDiagonal() * MatrixXd(motion.damping());
  // Removes translations of the whole packing, which keep their speed.
  for (Index k = 0; k < 2 * n; ++k)
    for (Index half : {Index{0}, n}) motion.hold_centre(a.col(k).segment(half, n));
  const Eigen::EigenSolver<MatrixXd> spectrum(a);
  valid = spectrum.info() == Eigen::Success;
  if (!valid) return {};
  std::vector<Ritz> found;
  for (Index k = 0; k < 2 * n; ++k) {
    const Complex lambda = spectrum.eigenvalues()[k];
    if (lambda.real() > above && lambda.imag() >= 0)
      found.push_back({lambda, 0, spectrum.eigenvectors().col(k).head(n)});
  }
  return found;
}

/// Refines an eigenvalue and its left and right eigenvectors by inverse iteration, with the eigenvalue itself
/// as the shift. Then computes the doubt of the eigenvalue. False if this fails or leads to a motion that
/// dies out.
template <class Number>
bool refine(const SmallMotion& motion, GrowingMode& mode) {
  using Vector = typename Factor<Number>::Vector;
  const auto narrow = [](const auto& x) {
    if constexpr (std::is_same_v<Number, double>)
      return x.real().eval();
    else
      return x;
  };
  const auto number = [](Complex x) {
    if constexpr (std::is_same_v<Number, double>)
      return x.real();
    else
      return x;
  };
  Number lambda = number(mode.lambda);
  Vector right = narrow(mode.motion).normalized();
  Vector left = right;
  constexpr int most = 6;
  for (int round = 0; round < most; ++round) {
    // The shift is slightly beside the eigenvalue, so that the factorization exists.
    const Factor<Number> factor(motion, lambda * (1 + 1e-7));
    if (!factor.valid()) return false;
    const auto slope = [&](const Vector& v) -> Vector {
      return 2.0 * lambda * motion.inertia().cwiseProduct(v) + motion.damping() * v;
    };
    const auto slope_adjoint = [&](const Vector& v) -> Vector {
      return 2.0 * Eigen::numext::conj(lambda) * motion.inertia().cwiseProduct(v) +
             motion.damping().transpose() * v;
    };
    for (int twice = 0; twice < 2; ++twice) {
      right = factor.solve(slope(right));
      left = factor.solve_adjoint(slope_adjoint(left));
      // Translations of the whole packing are eigenvectors of 0. Eigenvectors of any other lambda contain no
      // translation.
      motion.hold_centre(right);
      motion.hold_centre(left);
      right.normalize();
      left.normalize();
    }
    const Number before = lambda;
    const Vector k = motion.stiffness() * right;
    const Vector c = motion.damping() * right;
    const Vector m = motion.inertia().cwiseProduct(right);
    for (int step = 0; step < 5; ++step)
      lambda -=
          left.dot(Vector(lambda * lambda * m + lambda * c + k)) / left.dot(Vector(2.0 * lambda * m + c));
    mode.residual = (lambda * lambda * m + lambda * c + k).norm();
    if (round > 0 && std::real(lambda) < 0) return false;  // the motion dies out
    if (std::abs(lambda - before) > 1e-9 * std::abs(lambda)) continue;
    mode.lambda = lambda;
    mode.motion = right.template cast<Complex>();
    const double flat = flat_mode;  // a stiffness of 0 after rounding
    mode.doubt = (motion.doubt(left.template cast<Complex>(), mode.motion) + flat) /
                 std::abs(left.dot(Vector(2.0 * lambda * m + c)));
    return std::isfinite(mode.doubt);
  }
  return false;
}

/// Makes a mode of growth without oscillation consistent with Coulomb's law. Lets each contact at the limit
/// slide or stick as the motion of the mode requires, computes the mode again, and repeats this until no
/// contact changes. The result is a real motion of the packing. `way` is 1 or -1, the sign of the motion.
std::optional<GrowingMode> as_contacts_go(const SmallMotion& motion, const GrowingMode& mode, double way) {
  SmallMotion now = motion;
  GrowingMode found = mode;
  VectorXd z = way * mode.motion.real();
  VectorXd signs;
  constexpr int most = 30;
  for (int round = 0; round < most; ++round) {
    const VectorXd loading = now.loading(z, found.rate());
    if (signs.size() > 0 && (signs.array() == loading.array().sign()).all()) return found;
    signs = loading.array().sign();
    now = now.sliding_where(loading);
    found.motion = z.cast<Complex>();
    if (!refine<double>(now, found) || !found.grows()) return {};
    const VectorXd next = found.motion.real();
    z = next.dot(motion.inertia().cwiseProduct(z)) < 0 ? -next : next;
  }
  return {};
}

}  // namespace

const GrowingMode* Growth::fastest() const {
  const auto at = std::find_if(modes.begin(), modes.end(), [](const GrowingMode& m) { return m.grows(); });
  return at == modes.end() ? nullptr : &*at;
}

Growth find_growth(const SmallMotion& motion) {
  Growth growth;
  growth.asked = motion.unknowns() <= most_unknowns;
  if (!growth.asked || motion.particles() == 0) return growth;
  std::vector<Ritz> found;
  constexpr Index few = 60;
  if (motion.unknowns() <= few) {
    found = dense(motion, least_rate, growth.valid);
  } else {
    for (const double sigma : {0.003, 0.03, 0.3}) {
      constexpr Index vectors = 120;
      const auto more = arnoldi(motion, sigma, vectors, least_rate, growth.valid);
      if (!growth.valid) return growth;
      for (const Ritz& r : more)
        if (r.error < 0.1 * r.lambda.real()) found.push_back(r);
    }
  }
  std::sort(found.begin(), found.end(),
            [](const Ritz& a, const Ritz& b) { return a.lambda.real() > b.lambda.real(); });
  constexpr std::size_t most = 12;
  for (const Ritz& r : found) {
    const auto same = [&](const GrowingMode& m) {
      return std::abs(m.lambda - r.lambda) < 1e-3 * std::abs(r.lambda);
    };
    if (growth.modes.size() == most) break;
    if (std::any_of(growth.modes.begin(), growth.modes.end(), same)) continue;
    // Where contacts slide, an oscillation decides nothing: the fastest is told, the slower ones are passed
    // over.
    if (r.lambda.imag() != 0 && motion.slides() && growth.fastest()) continue;
    GrowingMode mode{.lambda = r.lambda, .motion = r.motion};
    const bool exact = r.lambda.imag() == 0 ? refine<double>(motion, mode) : refine<Complex>(motion, mode);
    if (!exact || !(mode.rate() > least_rate)) continue;
    if (mode.grows() && !motion.slides()) growth.certain = mode;
    if (mode.grows() && mode.lambda.imag() == 0)
      for (const double way : {1.0, -1.0})
        if (!growth.certain) growth.certain = as_contacts_go(motion, mode, way);
    growth.modes.push_back(mode);
    if (growth.certain) break;
  }
  return growth;
}

}  // namespace furnas
