#pragma once

#include <optional>
#include <string>

#include "cases/program/sweep/points.h"

namespace furnas {

/// phi_J of a large packing minus phi_J of a smaller one, and the uncertainty of this difference.
struct SizeShift {
  double value{};        ///< to be added to phi_J
  double uncertainty{};  ///< +-
};

/// The shift for the samples of a point that their number of spheres alone causes, where it has been measured
/// (docs/results/study.md, "The number of spheres"): for 500 equal spheres or more, with friction 0 or 0.3,
/// at pressures up to 1e-3. Empty elsewhere.
std::optional<SizeShift> size_shift(const Point& point);

/// "+0.0025 +- 0.0010", or "unknown"; empty where there is no phi_J.
std::string finite_size_text(const Point& point);

}  // namespace furnas
