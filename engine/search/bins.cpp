#include "engine/search/bins.h"

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <tuple>

#include "engine/base/parallel.h"
#include "engine/base/require.h"

namespace furnas {
namespace {

/// A grid finer than the particles only wastes look-ups; keys must also fit in 64 bits.
std::int64_t bins_along(double height, double cutoff) {
  constexpr double most = 1 << 20;
  return static_cast<std::int64_t>(std::clamp(std::floor(height / cutoff), 1.0, most));
}

/// Rows of the list tell apart thirty cells, and beyond a few nothing physical is left.
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

}  // namespace

Bins sort_into_bins(const Triangle& edges, double cutoff, const std::vector<Fraction>& positions,
                    std::size_t first, std::size_t last) {
  Bins bins;
  const Vec3<double> height = heights(edges);
  const std::array<double, 3> h{height.x, height.y, height.z};
  refuse_collapsed(h, cutoff);
  for (int axis = 0; axis < 3; ++axis) {
    bins.count[axis] = bins_along(h[axis], cutoff);
    bins.reach[axis] =
        static_cast<std::int64_t>(std::ceil(cutoff * static_cast<double>(bins.count[axis]) / h[axis]));
  }
  bins.entries.resize(last - first);
  for_chunks(last - first, 1024, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t n = begin; n < end; ++n) {
      const Vec3<double> s = in_unit_cell(positions[first + n]);
      bins.entries[n] = {bins.key(bins.coordinate(0, s.x), bins.coordinate(1, s.y), bins.coordinate(2, s.z)),
                         static_cast<std::uint32_t>(first + n), s};
    }
  });
  tbb::parallel_sort(bins.entries.begin(), bins.entries.end(), [](const Binned& a, const Binned& b) {
    return std::tie(a.key, a.index) < std::tie(b.key, b.index);
  });
  return bins;
}

}  // namespace furnas
