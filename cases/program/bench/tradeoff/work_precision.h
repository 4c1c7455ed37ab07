#pragma once

#include "cases/program/bench/tradeoff/comparison.h"
#include "viz/chart.h"

namespace furnas {

/// Chart of abs(difference to the reference), with its interval, against core seconds; both axes are
/// logarithmic, and each arm is a point. The reference is drawn at the half width of the interval of its own
/// mean: smaller differences cannot be resolved. An arm without a density is a cross at the upper edge, with
/// its verdicts. The chart is empty without a reference.
Chart work_precision_chart(const ComparedCase& compared);

}  // namespace furnas
