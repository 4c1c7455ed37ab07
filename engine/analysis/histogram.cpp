#include "engine/analysis/histogram.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "engine/base/require.h"

namespace furnas {

std::int64_t Histogram::values() const {
  return std::accumulate(counts.begin(), counts.end(), below + above);
}

double Histogram::density(std::size_t bin) const {
  if (values() == 0) return 0;
  return static_cast<double>(counts[bin]) / (static_cast<double>(values()) * width(bin));
}

Histogram histogram(const std::vector<double>& values, std::vector<double> edges) {
  require(edges.size() >= 2 && std::is_sorted(edges.begin(), edges.end()), "a histogram has rising edges");
  Histogram h{std::move(edges), {}};
  h.counts.resize(h.edges.size() - 1);
  for (const double x : values) {
    if (!(x >= h.edges.front())) {
      ++h.below;
    } else if (x > h.edges.back()) {
      ++h.above;
    } else {
      const auto after = std::upper_bound(h.edges.begin(), h.edges.end(), x) - h.edges.begin();
      ++h.counts[std::min(static_cast<std::size_t>(after), h.counts.size()) - 1];
    }
  }
  return h;
}

std::vector<double> linear_edges(double width, double most) {
  require(width > 0 && most >= 0 && most / width < 1e7, "a positive width, and not too many bins");
  const auto bins = static_cast<std::size_t>(std::max(1.0, std::ceil(most / width)));
  std::vector<double> edges;
  for (std::size_t n = 0; n <= bins; ++n) edges.push_back(static_cast<double>(n) * width);
  if (edges.back() < most) edges.push_back(static_cast<double>(bins + 1) * width);
  return edges;
}

std::vector<double> logarithmic_edges(int per_decade, double least, double most) {
  require(per_decade > 0 && least > 0 && most >= least, "positive values");
  const auto edge = [&](int n) { return std::pow(10.0, static_cast<double>(n) / per_decade); };
  int first = static_cast<int>(std::floor(per_decade * std::log10(least)));
  while (edge(first) > least) --first;
  std::vector<double> edges{edge(first)};
  do edges.push_back(edge(++first));
  while (edges.back() < most);
  return edges;
}

}  // namespace furnas
