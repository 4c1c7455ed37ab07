#pragma once

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
  double residual{};           ///< largest |K v - lambda v| of them, |v| = 1, by contacts without a matrix
  StrainMatrix relaxed = StrainMatrix::Zero();  ///< what strains cost when the particles follow [k_n d_s^2]
};

/// The strains that a cell may make, as columns.
Eigen::MatrixXd free_strains(CellFreedom freedom);

/// The lowest `count` modes. The cell's strains enter as the root mean square displacement they give to the
/// backbone, times the root of its number, so that eigenvalues do not depend on the unit of the strain.
Modes find_modes(const Stiffness& stiffness, CellFreedom freedom, int count);

}  // namespace furnas
