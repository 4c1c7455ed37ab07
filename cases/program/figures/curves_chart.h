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
  std::vector<std::string> values;                    ///< of the keys that tell the curves apart
  std::map<double, std::vector<std::size_t>> points;  ///< at each x the rows of its samples
};

/// What is drawn against what.
struct CurvesSubject {
  const Gathered& all;
  const Gathered& equal;  ///< samples of equal spheres, with the same keys, from which the model follows
  const Quantity& y;
  std::string x;                ///< a key
  std::vector<std::string> by;  ///< the keys that tell the curves apart
};

/// The means of the samples with their intervals, open where cells are too thin; for phi_J also what the
/// Furnas model says, where there are equal spheres of the same settings. Adds to `remarks` what is missing.
Chart chart_of(const std::vector<CurveOfSamples>& curves, const CurvesSubject& subject,
               std::vector<std::string>& remarks);

}  // namespace furnas
