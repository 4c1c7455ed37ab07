#pragma once

#include <complex>
#include <cstdint>
#include <optional>
#include <vector>

#include "engine/certificate/small_motion.h"

namespace furnas {

/// A small motion z e^(lambda t) of a backbone and its cell.
struct GrowingMode {
  std::complex<double> lambda;  ///< real part: rate of growth; imaginary part: angular frequency [1/time]
  double doubt{};               ///< uncertainty of lambda because the forces do not balance exactly [1/time]
  double residual{};            ///< |M lambda^2 z + C lambda z + K z|, |z| = 1 [k_n]
  Eigen::VectorXcd motion;      ///< z, of length 1

  double rate() const { return lambda.real(); }
  /// Whether the motion grows, with a rate above its doubt.
  bool grows() const { return rate() > doubt; }
};

/// With more unknowns than this find_growth() does not search, because the factorizations would take more
/// than a few minutes.
inline constexpr Eigen::Index most_unknowns = 50'000;

/// The growing motions that were found.
struct Growth {
  bool asked{};                    ///< the search was made: there were not too many unknowns
  bool valid{};                    ///< the equations of motion were solved, and every eigenvalue refined
  std::vector<GrowingMode> modes;  ///< the fastest, if contacts could slide both ways; at most 12
  /// A growing mode that is consistent: each contact at the Coulomb limit slides or sticks as the motion of
  /// the mode itself requires.
  std::optional<GrowingMode> certain;

  /// The fastest of `modes` whose growth exceeds its doubt; null if there is none.
  const GrowingMode* fastest() const;
};

/// Finds the growing motions of a backbone: eigenvalues lambda of M lambda^2 + C lambda + K with a positive
/// real part.
///
/// With few unknowns all eigenvalues are computed from a dense matrix. With many unknowns the equations are
/// written as x' = A x, and Arnoldi's method is applied to (A - sigma)^-1 for each of several real shifts
/// sigma, starting from a random motion. For each sigma M sigma^2 + C sigma + K is factored once (UMFPACK).
/// The method first finds the eigenvalues near sigma and those with a large real part. Each growing mode that
/// may decide and its left eigenvector are then refined with the mode's own lambda as the shift. The doubt
/// follows from both eigenvectors.
Growth find_growth(const SmallMotion& motion);

}  // namespace furnas
