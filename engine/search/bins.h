#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/state/cell.h"
#include "engine/state/fraction.h"

namespace furnas {

/// A particle in the bin it lies in.
struct Binned {
  std::uint64_t key;      ///< of the bin
  std::uint32_t index;    ///< of the particle
  Vec3<double> fraction;  ///< position in the cell, in [0, 1)
};

/// The particles of one size class sorted by the bins of a grid that fills the cell. Only occupied bins
/// cost memory, so a dilute gas in a huge cell is as cheap as a packing.
struct Bins {
  std::array<std::int64_t, 3> count{};  ///< bins along each edge
  std::array<std::int64_t, 3> reach{};  ///< bins to look at on each side to see all within the cutoff
  std::vector<Binned> entries;          ///< sorted by key, then index

  /// Bin along one edge of a fraction in [0, 1].
  std::int64_t coordinate(int axis, double fraction) const {
    const auto c = static_cast<std::int64_t>(fraction * static_cast<double>(count[axis]));
    return c < count[axis] ? c : count[axis] - 1;
  }
  std::uint64_t key(std::int64_t x, std::int64_t y, std::int64_t z) const {
    return static_cast<std::uint64_t>((x * count[1] + y) * count[2] + z);
  }
};

/// Sorts particles [first, last) into bins no narrower than `cutoff` where the cell allows it; where it
/// does not, one bin, whose `reach` counts the images. Throws NumericalFailure when the cell is less than a
/// thirtieth of the cutoff thick.
Bins sort_into_bins(const Triangle& edges, double cutoff, const std::vector<Fraction>& positions,
                    std::size_t first, std::size_t last);

}  // namespace furnas
