#pragma once

#include <cstdint>

#include "engine/minimize/enthalpy.h"

namespace furnas {

/// When forces and stress count as balanced: far below the limits of any verdict.
struct MinimumCriteria {
  double force_imbalance = 1e-8;  ///< mean |net force|/mean contact force
  double stress_error = 1e-7;     ///< largest deviation from the bath's stress/p_a
};

/// How a search for a minimum ended.
struct MinimumReport {
  bool reached{};              ///< the criteria hold
  bool stuck{};                ///< no step leads further down: rounding, or a packing that falls apart
  std::int64_t evaluations{};  ///< times that all forces were computed
};

/// Moves an enthalpy to a minimum near its place, at most `most` evaluations far, by the limited-memory
/// method of Broyden, Fletcher, Goldfarb and Shanno (Nocedal, Math. Comput. 35 (1980) 773; Nocedal and
/// Wright, Numerical Optimization, algorithm 7.4). Between two calls it forgets the curvatures that it has
/// learned. Needs ten times the memory of the positions, twice over.
MinimumReport find_minimum(Enthalpy& enthalpy, std::int64_t most, const MinimumCriteria& criteria = {});

}  // namespace furnas
