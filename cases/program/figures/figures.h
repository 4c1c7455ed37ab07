#pragma once

#include <string>
#include <vector>

#include "cases/program/figures/study.h"
#include "viz/chart.h"

namespace furnas {

/// A figure of the paper, or an additional figure.
struct Figure {
  std::string name;     ///< of its files, without extension
  std::string caption;  ///< a sentence
  Chart chart;
};

/// All figures that a study has data for.
std::vector<Figure> figures_of(const Study& study);

/// Adds to the title of a chart that its error bars are 95 % intervals, if it has any.
void explain_bars(Chart& chart);

/// A series without points, for the legend of a chart with open symbols.
Series open_symbol();

/// The numbers in a chart: series, x, y, the ends of the error bar, and "yes" where the cell is too thin. `x`
/// and `y` are the names of the columns.
std::string csv(const Chart& chart, const std::string& x = "x", const std::string& y = "y");

}  // namespace furnas
