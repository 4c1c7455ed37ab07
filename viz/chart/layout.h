#pragma once

#include <vector>

#include "viz/chart.h"
#include "viz/chart/canvas.h"
#include "viz/chart/ticks.h"

namespace furnas {

/// Where the parts of a chart stand. Data are drawn at (value or its logarithm) within the stretches.
struct ChartLayout {
  Stretch x, y;
  std::vector<Tick> x_ticks, y_ticks;
  Box frame;   ///< where the data are drawn
  Box legend;  ///< empty if there is none
};

/// Sizes of what a chart is made of, which grow with the chart [pixels].
struct ChartSizes {
  double label{};   ///< letters of numbers and of the legend
  double title{};   ///< letters of titles
  double gap{};     ///< between neighbours
  double symbol{};  ///< length of the sample of a line in the legend
  double row{};     ///< height of a row of the legend
  double line{};    ///< width of the lines of series
  double marker{};  ///< width of markers
};

/// For the width and height of the chart.
ChartSizes sizes_of(const Chart& chart);

/// Finds a place for everything, so that nothing covers anything else.
ChartLayout layout_of(const Chart& chart);

/// Where a value is drawn along an axis: itself or its decimal logarithm; not a number where it cannot be.
double shown(const ChartAxis& axis, double value);

}  // namespace furnas
