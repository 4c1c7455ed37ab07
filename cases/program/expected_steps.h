#pragma once

#include "io/case.h"

namespace furnas {

/// Estimated number of steps to rest of a case with so many particles, within a factor of two or three, and
/// at most stop.steps. An evaluation of the minimizer counts as one and a half steps.
double expected_steps(const Case& c, double particles);

}  // namespace furnas
