#include "engine/certificate/growth.h"

#include <Eigen/Eigenvalues>
#include <Eigen/UmfPackSupport>
#include <algorithm>
#include <cmath>
#include <new>
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

/// Factors L U of this matrix, by UMFPACK. Throws std::bad_alloc.
template <class Number>
class Factor : private Eigen::UmfPackLU<Eigen::SparseMatrix<Number>> {
 public:
  using Vector = Eigen::Matrix<Number, Eigen::Dynamic, 1>;

  Factor(const SmallMotion& motion, Number lambda) : matrix_(at(motion, lambda)) {
    this->umfpackControl()[UMFPACK_STRATEGY] = UMFPACK_STRATEGY_SYMMETRIC;  // of the pattern
    this->analyzePattern(matrix_);
    check_memory();
    this->factorize(matrix_);
    check_memory();
  }
  bool valid() const { return this->info() == Eigen::Success; }
  Vector solve(const Vector& b) const { return solved(UMFPACK_A, b); }
  /// Solves with the transposed, conjugated matrix.
  Vector solve_adjoint(const Vector& b) const { return solved(UMFPACK_At, b); }

 private:
  void check_memory() const {
    if (this->m_umfpackInfo[UMFPACK_STATUS] == UMFPACK_ERROR_out_of_memory) throw std::bad_alloc();
  }
  Vector solved(int system, const Vector& b) const {
    Vector x(b.size());
    Eigen::umfpack_solve(system, matrix_.outerIndexPtr(), matrix_.innerIndexPtr(), matrix_.valuePtr(),
                         x.data(), b.data(), this->m_numeric, this->m_control.data(),
                         this->m_umfpackInfo.data());
    check_memory();
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

/// No eigenvalue is larger than this. In coordinates in which M is 1, lambda^2 z = -(lambda C + K) z,
/// therefore |lambda|^2 <= |lambda| |C| + |K| in any norm of matrices; here the largest sum of a row.
double largest_eigenvalue(const SmallMotion& motion) {
  const VectorXd faster = motion.inertia().cwiseSqrt().cwiseInverse();
  const auto largest_row = [&](const auto& matrix) {
    VectorXd sums = VectorXd::Zero(motion.unknowns());
    const Eigen::SparseMatrix<double> scaled = faster.asDiagonal() * matrix * faster.asDiagonal();
    for (Index k = 0; k < scaled.outerSize(); ++k)
      for (Eigen::SparseMatrix<double>::InnerIterator entry(scaled, k); entry; ++entry)
        sums[entry.row()] += std::abs(entry.value());
    return sums.maxCoeff();
  };
  const double c = largest_row(motion.damping()), k = largest_row(motion.stiffness());
  return c / 2 + std::sqrt(c * c / 4 + k);
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

/// What became of a growing motion when its eigenvalue was refined.
enum class Refined { exact, dies_out, failed };

template <class Number>
using VectorOf = typename Factor<Number>::Vector;

/// A motion z in the equations: lambda^2 M z + lambda C z + K z.
template <class Number>
struct Equations {
  VectorOf<Number> inertial, damped, stiff;  ///< M z, C z, K z

  Equations(const SmallMotion& motion, const VectorOf<Number>& z)
      : inertial(motion.inertia().cwiseProduct(z)),
        damped(motion.damping() * z),
        stiff(motion.stiffness() * z) {}
  VectorOf<Number> left_over(Number lambda) const {
    return lambda * lambda * inertial + lambda * damped + stiff;
  }
  VectorOf<Number> slope(Number lambda) const { return 2.0 * lambda * inertial + damped; }
};

/// Two steps of inverse iteration for the right and the left eigenvector of lambda. False if the matrix
/// cannot be factored.
template <class Number>
bool iterate(const SmallMotion& motion, Number lambda, VectorOf<Number>& right, VectorOf<Number>& left) {
  // The shift is slightly beside the eigenvalue, so that the factorization exists.
  const Factor<Number> factor(motion, lambda * (1 + 1e-7));
  if (!factor.valid()) return false;
  for (int twice = 0; twice < 2; ++twice) {
    right = factor.solve(2.0 * lambda * motion.inertia().cwiseProduct(right) + motion.damping() * right);
    left = factor.solve_adjoint(2.0 * Eigen::numext::conj(lambda) * motion.inertia().cwiseProduct(left) +
                                motion.damping().transpose() * left);
    // Translations of the whole packing are eigenvectors of 0. Eigenvectors of any other lambda contain no
    // translation.
    motion.hold_centre(right);
    motion.hold_centre(left);
    right.normalize();
    left.normalize();
  }
  return true;
}

/// Refines an eigenvalue and its left and right eigenvectors by inverse iteration, with the eigenvalue itself
/// as the shift. Then computes the doubt of the eigenvalue.
template <class Number>
Refined refine(const SmallMotion& motion, GrowingMode& mode) {
  using Vector = VectorOf<Number>;
  Number lambda;
  Vector right;
  if constexpr (std::is_same_v<Number, double>)
    lambda = mode.lambda.real(), right = mode.motion.real().normalized();
  else
    lambda = mode.lambda, right = mode.motion.normalized();
  Vector left = right;
  constexpr int most = 12;  // a Ritz value far from any eigenvalue needs some rounds to reach one
  for (int round = 0; round < most; ++round) {
    if (!iterate(motion, lambda, right, left)) return Refined::failed;
    const Number before = lambda;
    const Equations<Number> equations(motion, right);
    for (int step = 0; step < 5; ++step)
      lambda -= left.dot(equations.left_over(lambda)) / left.dot(equations.slope(lambda));
    if (round > 0 && std::real(lambda) < 0) return Refined::dies_out;
    // Rounding moves a small lambda by more than 1e-9 of itself, but by far less than its doubt.
    const double sensitivity = 1 / std::abs(left.dot(equations.slope(lambda)));  // d lambda/d stiffness
    const double rounding = flat_mode * sensitivity;
    if (std::abs(lambda - before) > std::max(1e-9 * std::abs(lambda), 1e-3 * rounding)) continue;
    mode.lambda = lambda;
    mode.motion = right.template cast<Complex>();
    mode.residual = equations.left_over(lambda).norm();
    mode.doubt = motion.doubt(left.template cast<Complex>(), mode.motion) * sensitivity + rounding;
    return std::isfinite(mode.doubt) ? Refined::exact : Refined::failed;
  }
  return Refined::failed;
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
    if (refine<double>(now, found) != Refined::exact || !found.grows()) return {};
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
    // A theta that is 0 but for rounding makes a lambda beyond any eigenvalue.
    const double largest = 1.01 * largest_eigenvalue(motion);
    for (const double sigma : {0.003, 0.03, 0.3}) {
      constexpr Index vectors = 120;
      const auto more = arnoldi(motion, sigma, vectors, least_rate, growth.valid);
      if (!growth.valid) return growth;
      for (const Ritz& r : more)
        if (r.error < 0.1 * r.lambda.real() && std::abs(r.lambda) <= largest) found.push_back(r);
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
    const Refined refined =
        r.lambda.imag() == 0 ? refine<double>(motion, mode) : refine<Complex>(motion, mode);
    if (refined == Refined::failed) growth.valid = false;
    if (refined != Refined::exact || !(mode.rate() > least_rate)) continue;
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
