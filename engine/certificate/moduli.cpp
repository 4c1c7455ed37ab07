#include "engine/certificate/moduli.h"

#include <Eigen/Eigenvalues>
#include <cmath>

namespace furnas {

Moduli moduli_of(const StrainMatrix& c) {
  const double lengths = c(0, 0) + c(1, 1) + c(2, 2);
  const double across = c(0, 1) + c(0, 2) + c(1, 2);
  const double tilts = c(3, 3) + c(4, 4) + c(5, 5);
  Moduli moduli;
  moduli.bulk = (lengths + 2 * across) / 9;
  moduli.shear = (lengths - across + 3 * tilts) / 15;
  // Tilts of the cell are twice the shear components of the strain tensor. With these weights (Kelvin's
  // notation) the eigenvalues do not depend on the choice of axes.
  Strain weight;
  weight << 1, 1, 1, std::sqrt(2), std::sqrt(2), std::sqrt(2);
  const StrainMatrix kelvin = weight.asDiagonal() * c * weight.asDiagonal();
  moduli.least_shear = Eigen::SelfAdjointEigenSolver<StrainMatrix>(kelvin).eigenvalues()[0] / 2;
  return moduli;
}

}  // namespace furnas
