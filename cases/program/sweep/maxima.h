#pragma once

#include <span>
#include <string>
#include <vector>

#include "cases/program/sweep/points.h"

namespace furnas {

/// A column of maxima.csv after those of the keys (without small_fraction).
struct MaximumColumn {
  OutputField about;
  std::string (*cell)(const Curve&, const CurveMaximum&);
};

/// All columns, in the order of the file.
std::span<const MaximumColumn> maximum_columns();

/// maxima.csv as text: a row for each curve of three points or more.
std::string maxima_csv(const std::vector<Curve>& curves, const std::vector<std::string>& keys);

}  // namespace furnas
