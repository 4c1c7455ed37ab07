#pragma once

#include "cases/program/bench/tradeoff/comparison.h"
#include "viz/chart.h"

namespace furnas {

/// abs(difference to the reference) with its interval against core seconds, both logarithmic, an arm a point.
/// The reference stands where the interval of its own mean ends, which no arm can be told apart below; an arm
/// without a density stands as a cross at the upper edge, with its verdicts. Empty without a reference.
Chart work_precision_chart(const ComparedCase& compared);

}  // namespace furnas
