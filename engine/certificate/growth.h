#pragma once

#include <complex>
#include <cstdint>
#include <optional>
#include <vector>

#include "engine/certificate/small_motion.h"

namespace furnas {

/// A motion z e^(lambda t) of a backbone and its cell.
struct GrowingMode {
  std::complex<double> lambda;  ///< its real part is the rate, the other the angular frequency [1/time]
  double doubt{};               ///< of lambda, for want of balance [1/time]
  double residual{};            ///< |M lambda^2 z + C lambda z + K z|, |z| = 1 [k_n]
  Eigen::VectorXcd motion;      ///< z, of length 1

  double rate() const { return lambda.real(); }
  /// Whether it grows, and by more than it is in doubt.
  bool grows() const { return rate() > doubt; }
};

/// With more unknowns the factors would take more than some minutes: nothing is looked for.
inline constexpr Eigen::Index most_unknowns = 50'000;

/// What was found of the motions that grow.
struct Growth {
  bool asked{};                    ///< there were not too many unknowns
  bool valid{};                    ///< the equations of motion could be solved
  std::vector<GrowingMode> modes;  ///< the fastest that grow, were contacts to slide both ways; at most 12
  /// The mode in which each contact at its limit slides or sticks as the motion of the mode asks.
  std::optional<GrowingMode> certain;

  /// Of the former the fastest that is not in doubt; null if there is none.
  const GrowingMode* fastest() const;
};

/// The motions of a backbone that grow: eigenvalues lambda of M lambda^2 + C lambda + K with a positive real
/// part.
///
/// Few unknowns: all of them, from a dense matrix. Many: Arnoldi's method on (A - sigma)^-1, x' = A x, for
/// each of several real shifts sigma, from a random motion; M sigma^2 + C sigma + K is factored once each
/// (UMFPACK). The method finds eigenvalues near sigma first, and those far to the right. A mode that grows is
/// then refined with its own lambda as the shift, and so is its left eigenvector, from which its doubt
/// follows.
Growth find_growth(const SmallMotion& motion);

}  // namespace furnas
