#include "engine/search/grid.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "engine/base/counting_sort.h"
#include "engine/base/refill.h"
#include "engine/base/require.h"

namespace furnas {
namespace {

/// Rejects a cell so thin that spheres touch across thirty cells or more. A row of the list cannot
/// distinguish more images, and a cell so thin has no physical meaning.
void refuse_collapsed(const std::array<double, 3>& heights, double cutoff) {
  constexpr double most_cells = 30;
  for (double height : heights) {
    if (!std::isfinite(height) || !std::isfinite(cutoff))
      throw NumericalFailure(
          "the edges of the cell are no numbers any more: it is too light or pressed too hard");
    if (cutoff >= most_cells * height)
      throw NumericalFailure("the cell has collapsed: between two of its faces are " +
                             std::to_string(height) + " d_s, and spheres meet at " + std::to_string(cutoff) +
                             " d_s");
  }
}

/// Number of bins along each edge: bins are about as wide as the cutoff, but there are at most about two per
/// particle in all.
std::array<std::int64_t, 3> bins_along(const std::array<double, 3>& heights, double cutoff,
                                       std::size_t particles) {
  std::array<double, 3> wanted{};
  for (int axis = 0; axis < 3; ++axis) wanted[axis] = std::max(heights[axis] / cutoff, 1.0);
  const double most = 2 * static_cast<double>(particles) + 8;
  // An edge that has become one bin long leaves what is still too much to the others.
  for (int round = 0; round < 3; ++round) {
    const double all = wanted[0] * wanted[1] * wanted[2];
    const auto longer = std::count_if(wanted.begin(), wanted.end(), [](double bins) { return bins > 1; });
    if (all <= most || longer == 0) break;
    const double shrink = std::pow(most / all, 1.0 / static_cast<double>(longer));
    for (double& bins : wanted)
      if (bins > 1) bins = std::max(bins * shrink, 1.0);
  }
  std::array<std::int64_t, 3> count{};
  for (int axis = 0; axis < 3; ++axis) count[axis] = static_cast<std::int64_t>(wanted[axis]);
  return count;
}

}  // namespace

Grid make_grid(const Triangle& edges, double cutoff, const std::vector<Fraction>& positions,
               std::size_t first, std::size_t last, Grid former) {
  Grid grid = std::move(former);
  const Vec3<double> height = heights(edges);
  const std::array<double, 3> h{height.x, height.y, height.z};
  refuse_collapsed(h, cutoff);
  grid.cutoff = cutoff;
  grid.count = bins_along(h, cutoff, last - first);

  const auto position_of = [&](std::size_t n) { return in_unit_cell(positions[first + n]); };
  const auto bin_of = [&](std::size_t n) {
    const Vec3<double> s = position_of(n);
    return grid.bin(grid.coordinate(0, s.x), grid.coordinate(1, s.y), grid.coordinate(2, s.z));
  };
  const auto bins = static_cast<std::size_t>(grid.count[0] * grid.count[1] * grid.count[2]);
  refill(grid.entries, last - first + Grid::spare);
  counting_sort(last - first, bins, grid.start, bin_of, [&](std::size_t place, std::size_t n) {
    grid.entries[place] = {position_of(n), static_cast<std::uint32_t>(first + n)};
  });
  return grid;
}

}  // namespace furnas
