#pragma once

#include "engine/certificate/stiffness.h"

namespace furnas {

/// How a packing resists small strains while its particles follow in balance [k_n/d_s].
struct Moduli {
  double bulk{};         ///< K = -V dp/dV
  double shear{};        ///< G, the mean over all directions (Voigt)
  double least_shear{};  ///< the smallest of any direction; no larger than 3/2 K
};

/// From the elastic constants, the relaxed stiffness over V, in the order xx yy zz xy xz yz. A strain of
/// an upper-triangular cell is a symmetric strain, as in textbooks, and a rotation, which costs no energy.
Moduli moduli_of(const StrainMatrix& constants);

}  // namespace furnas
