#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "engine/certificate/stiffness.h"
#include "engine/state/cell.h"

namespace furnas {

/// An eigenvalue of this size or below is no more than rounding makes of 0 [k_n].
inline constexpr double flat_mode = 1e-10;

/// The softest motions of a backbone in its cell.
struct Modes {
  bool valid{};                ///< the stiffness could be factored and the eigenvalues converged
  std::int64_t negative{};     ///< eigenvalues below 0, counted exactly
  std::vector<double> lowest;  ///< eigenvalues nearest to 0, without the translations, rising [k_n]
  std::vector<double> doubt;   ///< how far each of them is in doubt, for want of balance [k_n]
  double residual{};           ///< largest |K v - lambda v| of them, |v| = 1, by contacts without a matrix
  StrainMatrix relaxed = StrainMatrix::Zero();  ///< what strains cost when the particles follow [k_n d_s^2]

  /// Whether the k-th mode is flat or negative, and its doubt is larger than its size: no spring resists the
  /// mode, and the sign of its prestress depends on forces that are smaller than the imbalance.
  bool open(std::size_t k) const {
    return lowest[k] < flat_mode && doubt[k] > std::max(std::abs(lowest[k]), flat_mode);
  }
  /// Number of modes that are negative or flat beyond doubt; a negative mode that was not looked at counts.
  std::int64_t unstable() const;
};

/// The strains that a cell may make, as columns.
Eigen::MatrixXd free_strains(CellFreedom freedom);

/// The displacement that a strain of 1 gives to a backbone, squared and summed over its particles, the root
/// of that: a strain e moves a particle at x by e x, and x^2 is L^2/12 in the mean [d_s].
double displacement_of_strain(double volume, std::int64_t backbone);

/// The lowest `count` modes, and where there are negative ones more, up to 400 in all. The cell's strains
/// enter as the root mean square displacement they give to the backbone, times the root of its number, so
/// that eigenvalues do not depend on the unit of the strain.
Modes find_modes(const Stiffness& stiffness, CellFreedom freedom, int count);

}  // namespace furnas
