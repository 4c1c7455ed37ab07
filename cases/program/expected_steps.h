#pragma once

#include "io/case.h"

namespace furnas {

/// Estimated number of steps to the verdict of a case with so many particles, within a factor of three, and
/// at most stop.steps. An evaluation of the minimizer counts as one and a half steps.
double expected_steps(const Case& c, double particles);

}  // namespace furnas
