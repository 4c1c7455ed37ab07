#pragma once

#include "engine/certificate/stiffness.h"

namespace furnas {

/// Elastic moduli of a packing whose particles relax to balance under small strains [k_n/d_s].
struct Moduli {
  double bulk{};         ///< K = -V dp/dV
  double shear{};        ///< G, the mean over all directions (Voigt)
  double least_shear{};  ///< the smallest shear modulus of any direction; at most 3/2 K
};

/// The moduli from the elastic constants: the relaxed stiffness divided by V, in the order xx yy zz xy xz yz.
/// A strain of an upper-triangular cell is the sum of a symmetric strain, as in textbooks, and a rotation,
/// which costs no energy.
Moduli moduli_of(const StrainMatrix& constants);

}  // namespace furnas
