#pragma once

#include <string>
#include <vector>

#include "engine/analysis/analyze.h"
#include "viz/chart.h"

namespace furnas {

/// A chart and the name of its files, without extension.
struct NamedChart {
  std::string name;
  Chart chart;
};

/// Charts of the distributions that an analysis contains: forces, mobilisation, rattlers, g(r).
std::vector<NamedChart> analysis_charts(const Analysis& analysis);

}  // namespace furnas
