#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "engine/certificate/stiffness.h"
#include "engine/state/cell.h"

namespace furnas {

/// Because of rounding an eigenvalue with at most this absolute value cannot be distinguished from 0 [k_n].
inline constexpr double flat_mode = 1e-10;

/// The softest motions of a backbone in its cell.
struct Modes {
  bool valid{};                ///< the stiffness could be factored and the eigenvalues converged
  std::int64_t negative{};     ///< eigenvalues below 0 (below -flat_mode if all are computed)
  std::vector<double> lowest;  ///< eigenvalues nearest to 0, rising, without the translations [k_n]
  std::vector<double> doubt;   ///< their uncertainty because forces do not balance exactly [k_n]
  double residual{};           ///< largest |K v - lambda v|, |v| = 1, with K v summed over contacts
  /// Motions of the modes below flat_mode, whether or not their sign is in doubt: u and R theta of each
  /// particle of the backbone.
  std::vector<Eigen::VectorXd> unresisted{};
  StrainMatrix relaxed = StrainMatrix::Zero();  ///< stiffness of the strains [k_n d_s^2]

  /// Whether the k-th eigenvalue is flat or negative, with a doubt larger than its absolute value. Then no
  /// spring resists the mode, and the sign of the prestress term depends on forces that are smaller than the
  /// imbalance.
  bool open(std::size_t k) const {
    return lowest[k] < flat_mode && doubt[k] > std::max(std::abs(lowest[k]), flat_mode);
  }
  /// Number of modes that are certainly negative or flat. Negative modes without a computed eigenvector count
  /// as certain.
  std::int64_t unstable() const;
};

/// The strains that a cell is free to make, as columns.
Eigen::MatrixXd free_strains(CellFreedom freedom);

/// Root of the sum over the backbone's particles of the squared displacement by a strain of 1 [d_s]. A strain
/// e displaces a particle at x by e x, and the mean of x^2 is L^2/12.
double displacement_of_strain(double volume, std::int64_t backbone);

/// Finds the lowest `count` modes; if there are negative ones, more modes, up to 400 in all. The unknowns of
/// the cell are its strains times displacement_of_strain(), so that eigenvalues do not depend on the unit of
/// the strain.
Modes find_modes(const Stiffness& stiffness, CellFreedom freedom, int count);

}  // namespace furnas
