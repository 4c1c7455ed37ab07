#pragma once

#include <map>
#include <string>
#include <vector>

#include "cases/program/figures/gather.h"
#include "cases/program/figures/quantity.h"
#include "viz/chart.h"

namespace furnas {

/// The samples that make one curve.
struct CurveOfSamples {
  std::vector<std::string> values;                    ///< of the keys that differ between curves
  std::map<double, std::vector<std::size_t>> points;  ///< at each x the rows of its samples
};

/// The quantities on the axes, and the samples.
struct CurvesSubject {
  const Gathered& all;
  const Gathered& equal;  ///< samples of equal spheres, with the same keys, for the model
  const Quantity& y;
  std::string x;                ///< a key
  std::vector<std::string> by;  ///< the keys that differ between curves
};

/// Chart of the means of the samples with their intervals. Symbols are open where cells are too thin. For
/// phi_J the chart includes the Furnas model, where there are equal spheres with the same settings. Adds a
/// remark on each missing part to `remarks`.
Chart chart_of(const std::vector<CurveOfSamples>& curves, const CurvesSubject& subject,
               std::vector<std::string>& remarks);

}  // namespace furnas
