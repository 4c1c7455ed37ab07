#pragma once

#include <optional>
#include <string>

#include "cases/program/sweep/points.h"

namespace furnas {

/// What phi_J of a large packing is above that of a smaller one, and how well that is known.
struct SizeShift {
  double value{};        ///< to be added to phi_J
  double uncertainty{};  ///< +-
};

/// The shift of the samples of a point, because of their number of spheres alone, where it has been measured
/// (docs/results/study.md, "The number of spheres"): for 500 equal spheres or more, without friction and with
/// 0.3, at pressures up to 1e-3. Nothing elsewhere.
std::optional<SizeShift> size_shift(const Point& point);

/// "+0.0025 +- 0.0010", or "unknown"; empty where there is no phi_J.
std::string finite_size_text(const Point& point);

}  // namespace furnas
