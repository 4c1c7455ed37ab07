#pragma once

#include <optional>
#include <string>

#include "cases/program/sweep/points.h"

namespace furnas {

/// What phi_J of a large packing is above that of the samples of a point, because of their number of spheres
/// alone, as docs/results/study/size has measured it: for equal spheres, without friction and with 0.1 or
/// more, at pressures up to 1e-3, in samples of 50 spheres or more. Nothing where that is not known.
std::optional<double> finite_size_shift(const Point& point);

/// "+0.0021", or "unknown".
std::string finite_size_text(const Point& point);

}  // namespace furnas
