#pragma once

#include <cstdint>
#include <vector>

namespace furnas {

/// How often values fall between edges.
struct Histogram {
  std::vector<double> edges;  ///< rising; a bin includes its lower edge, the last bin also its upper edge
  std::vector<std::int64_t> counts;  ///< in each bin
  std::int64_t below{}, above{};     ///< values outside

  std::size_t bins() const { return counts.size(); }
  double width(std::size_t bin) const { return edges[bin + 1] - edges[bin]; }
  /// All values, those outside too.
  std::int64_t values() const;
  /// Probability density: share of the bin in all values, divided by the bin's width. Its integral is 1 if no
  /// value lies outside the edges.
  double density(std::size_t bin) const;
};

/// Counts values between edges, which ascend. Values below the first and above the last edge are counted
/// apart; a value on an edge belongs to the bin above it, on the last edge to the last bin.
Histogram histogram(const std::vector<double>& values, std::vector<double> edges);

/// Edges 0, width, 2 width ... up to at least `most`.
std::vector<double> linear_edges(double width, double most);

/// Edges 10^(n/per_decade) from at most `least` > 0 to at least `most`.
std::vector<double> logarithmic_edges(int per_decade, double least, double most);

}  // namespace furnas
