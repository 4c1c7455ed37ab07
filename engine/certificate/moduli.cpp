#include "engine/certificate/moduli.h"

#include <Eigen/Eigenvalues>

namespace furnas {

Moduli moduli_of(const StrainMatrix& c) {
  const double lengths = c(0, 0) + c(1, 1) + c(2, 2);
  const double across = c(0, 1) + c(0, 2) + c(1, 2);
  const double tilts = c(3, 3) + c(4, 4) + c(5, 5);
  Moduli moduli;
  moduli.bulk = (lengths + 2 * across) / 9;
  moduli.shear = (lengths - across + 3 * tilts) / 15;
  moduli.least = Eigen::SelfAdjointEigenSolver<StrainMatrix>(c).eigenvalues()[0];
  return moduli;
}

}  // namespace furnas
