#pragma once

#include <cstdint>

#include "engine/minimize/enthalpy.h"

namespace furnas {

/// When forces and stress count as balanced. The limits are far below those of any verdict.
struct MinimumCriteria {
  double force_imbalance = 1e-8;  ///< mean |net force|/mean contact force
  double stress_error = 1e-7;     ///< largest deviation from the bath's stress/p_a
};

/// How a search for a minimum ended.
struct MinimumReport {
  bool reached{};  ///< the criteria are met
  bool stuck{};    ///< no step lowers the enthalpy further, because of rounding or because the packing falls
                   ///< apart
  std::int64_t evaluations{};  ///< number of times that all forces were computed
};

/// Moves the place of an enthalpy towards a minimum nearby, with about `most` evaluations at most, by the
/// limited-memory method of Broyden, Fletcher, Goldfarb and Shanno (Nocedal, Math. Comput. 35 (1980) 773;
/// Nocedal and Wright, Numerical Optimization, algorithm 7.4). The curvatures found in one call are not kept
/// for the next. The ten pairs of vectors that the method stores take twenty times the memory of the
/// positions.
MinimumReport find_minimum(Enthalpy& enthalpy, std::int64_t most, const MinimumCriteria& criteria = {});

}  // namespace furnas
