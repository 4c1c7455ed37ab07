#pragma once

#include <string>
#include <vector>

#include "cases/program/figures/study.h"
#include "viz/chart.h"

namespace furnas {

/// A figure of the paper, or one beside it.
struct Figure {
  std::string name;     ///< of its files, without extension
  std::string caption;  ///< a sentence
  Chart chart;
};

/// All figures that a study has data for.
std::vector<Figure> figures_of(const Study& study);

/// What a chart shows as numbers: series, x, y and the ends of the error bar.
std::string csv(const Chart& chart);

}  // namespace furnas
