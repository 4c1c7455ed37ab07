#pragma once

#include <vector>

#include "viz/chart.h"
#include "viz/chart/canvas.h"
#include "viz/chart/ticks.h"

namespace furnas {

/// The positions of the parts of a chart. Data are drawn by their value, or its decimal logarithm, within the
/// stretches.
struct ChartLayout {
  Stretch x, y;
  std::vector<Tick> x_ticks, y_ticks;
  Box frame;   ///< where the data are drawn
  Box legend;  ///< empty if there is none

  /// Position on the canvas of a coordinate along an axis (`shown`).
  double along_x(double coordinate) const;
  double along_y(double coordinate) const;
};

/// Sizes of the elements of a chart, proportional to the size of the chart [pixels].
struct ChartSizes {
  double label{};   ///< letters of numbers and of the legend
  double title{};   ///< letters of titles
  double gap{};     ///< between neighbouring elements
  double symbol{};  ///< length of the sample of a line in the legend
  double row{};     ///< height of a row of the legend
  double line{};    ///< width of the lines of series
  double marker{};  ///< width of markers
};

/// The sizes for the width and height of the chart.
ChartSizes sizes_of(const Chart& chart);

/// Places all elements such that none covers another.
ChartLayout layout_of(const Chart& chart);

/// Coordinate of a value along an axis: the value or its decimal logarithm; NaN if it cannot be shown.
double shown(const ChartAxis& axis, double value);

/// Position of a point of the data on the canvas; not finite if an axis cannot show it.
Spot spot_of(const Chart& chart, const ChartLayout& layout, double x, double y);

/// Whether a position is finite.
bool finite(const Spot& spot);

/// Number of spots in a box or nearer to it than `gap` [pixels].
std::size_t covered(const Box& box, const std::vector<Spot>& spots, double gap);

}  // namespace furnas
