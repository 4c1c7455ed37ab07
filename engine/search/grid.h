#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "engine/state/cell.h"
#include "engine/state/fraction.h"

namespace furnas {

/// A particle in its bin.
struct Placed {
  Vec3<double> fraction;  ///< position in the cell, in [0, 1]
  std::uint32_t index;    ///< of the particle
};

/// The particles of one size class in the bins of a grid that fills the cell. In dilute systems the bins are
/// larger, so that there are at most about two bins per particle. A dilute gas in a huge cell then costs no
/// more than a packing.
struct Grid {
  std::array<std::int64_t, 3> count{};  ///< bins along each edge
  double cutoff{};  ///< largest distance at which two particles of the class are listed [d_s]
  std::vector<std::uint32_t> start;  ///< entries of a bin are [start[bin], start[bin + 1])
  std::vector<Placed> entries;  ///< sorted by bin, in any order within a bin; then `spare` unused entries
  static constexpr std::size_t spare = 4;

  /// Number of the bin along an edge, for a fraction in [0, 1].
  std::int64_t coordinate(int axis, double fraction) const {
    const auto c = static_cast<std::int64_t>(fraction * static_cast<double>(count[axis]));
    return c < count[axis] ? c : count[axis] - 1;
  }
  std::size_t bin(std::int64_t x, std::int64_t y, std::int64_t z) const {
    return static_cast<std::size_t>((z * count[1] + y) * count[0] + x);
  }
};

/// Sorts particles [first, last) into bins; uses the memory of a `former` grid. Throws NumericalFailure if
/// the thickness of the cell is a thirtieth of the cutoff or less, or if its edges are not finite.
Grid make_grid(const Triangle& edges, double cutoff, const std::vector<Fraction>& positions,
               std::size_t first, std::size_t last, Grid former = {});

/// A bin along one edge of the grid, which continues periodically beyond the cell.
struct Wrapped {
  std::int64_t index;  ///< in [0, count)
  std::int64_t cell;   ///< which cell it lies in, counted from the original cell 0
};

inline Wrapped wrapped(std::int64_t bin, std::int64_t count) {
  if (bin >= 0 && bin < count) return {bin, 0};
  const std::int64_t cell = (bin >= 0 ? bin : bin - count + 1) / count;
  return {bin - cell * count, cell};
}

/// Calls visit(entries begin, entries end, image) for the bins [low, high] along x in column (y, z). `image`
/// is the cell in which the bins lie, relative to the original cell.
template <class Visit>
void visit_run(const Grid& grid, std::int64_t low, std::int64_t high, const Wrapped& y, const Wrapped& z,
               Visit&& visit) {
  while (low <= high) {
    const Wrapped x = wrapped(low, grid.count[0]);
    const std::int64_t last = std::min(x.index + (high - low), grid.count[0] - 1);
    const Placed* const entries = grid.entries.data();
    const Vec3<double> image{static_cast<double>(x.cell), static_cast<double>(y.cell),
                             static_cast<double>(z.cell)};
    visit(entries + grid.start[grid.bin(x.index, y.index, z.index)],
          entries + grid.start[grid.bin(last, y.index, z.index) + 1], image);
    low += last - x.index + 1;
  }
}

/// An interval of numbers.
struct Bounds {
  double low, high;
  /// The smallest absolute value in the interval.
  double least() const { return low > 0 ? low : high < 0 ? -high : 0; }
  Bounds operator+(const Bounds& b) const { return {low + b.low, high + b.high}; }
};
inline Bounds operator*(double a, const Bounds& b) {
  return a >= 0 ? Bounds{a * b.low, a * b.high} : Bounds{a * b.high, a * b.low};
}

/// Visits all bins with points that may be within `radius` of a centre in the cell `edges`: first slabs along
/// z, in them columns along y, in them runs along x. Because the edges are upper-triangular, the bounds of y
/// follow from those of z, and the bounds of x from both. Calls visit as visit_run() does.
template <class Visit>
void visit_ball(const Grid& grid, const Triangle& edges, const Vec3<double>& centre, double radius,
                Visit&& visit) {
  const auto extent = [&](int axis, std::int64_t bin, double middle) {
    const double width = 1 / static_cast<double>(grid.count[axis]);
    return Bounds{static_cast<double>(bin) * width - middle, static_cast<double>(bin + 1) * width - middle};
  };
  // First and last bin along an axis in which |step s + rest| can be below `reach`.
  const auto bins = [&](int axis, double step, const Bounds& rest, double reach, double middle) {
    const auto n = static_cast<double>(grid.count[axis]);
    return std::pair{static_cast<std::int64_t>(std::floor(((-reach - rest.high) / step + middle) * n)),
                     static_cast<std::int64_t>(std::floor(((reach - rest.low) / step + middle) * n))};
  };
  const auto [z_low, z_high] = bins(2, edges.zz, {0, 0}, radius, centre.z);
  for (std::int64_t z = z_low; z <= z_high; ++z) {
    const Bounds sz = extent(2, z, centre.z);
    const double left_z = radius * radius - std::pow((edges.zz * sz).least(), 2);
    if (left_z < 0) continue;
    const Bounds shift_y = edges.yz * sz;
    const auto [y_low, y_high] = bins(1, edges.yy, shift_y, std::sqrt(left_z), centre.y);
    for (std::int64_t y = y_low; y <= y_high; ++y) {
      const Bounds sy = extent(1, y, centre.y);
      const double left_y = left_z - std::pow((edges.yy * sy + shift_y).least(), 2);
      if (left_y < 0) continue;
      const Bounds shift_x = edges.xy * sy + edges.xz * sz;
      const auto [x_low, x_high] = bins(0, edges.xx, shift_x, std::sqrt(left_y), centre.x);
      visit_run(grid, x_low, x_high, wrapped(y, grid.count[1]), wrapped(z, grid.count[2]), visit);
    }
  }
}

}  // namespace furnas
