#include "engine/certificate/overlaps.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace furnas {
namespace {

using Cells = std::array<std::int64_t, 3>;

std::array<double, 3> components(const Vec3<double>& v) { return {v.x, v.y, v.z}; }

/// The number of the grid for spheres of this radius: radii between successive powers of 2 share a grid.
int octave(double radius) { return std::ilogb(radius); }

/// The particles of one octave in the bins of a grid that fills the cell.
class Grid {
 public:
  Grid(const Packing& p, const std::vector<std::uint32_t>& members) {
    for (const std::uint32_t k : members) largest_ = std::max(largest_, p.radius[k]);
    const auto height = components(heights(p.cell.edges));
    // Limits the number of bins, because with more bins than particles most would be empty.
    const double most = std::floor(std::cbrt(static_cast<double>(members.size()))) + 1;
    for (std::size_t a = 0; a < 3; ++a) {
      height_[a] = height[a];
      count_[a] = static_cast<std::int64_t>(std::clamp(std::floor(height[a] / (2 * largest_)), 1.0, most));
    }
    bins_.resize(static_cast<std::size_t>(count_[0] * count_[1] * count_[2]));
    for (const std::uint32_t k : members) {
      const auto s = components(in_unit_cell(p.fraction[k]));
      Cells at;
      for (std::size_t a = 0; a < 3; ++a) at[a] = std::min(bin(a, s[a]), count_[a] - 1);
      bins_[place(at)].push_back(k);
    }
  }

  /// Calls meet(k, cells) for every particle k of the grid and every image of it, `cells` away from the cell,
  /// that may touch a sphere of this centre and radius.
  template <class Meet>
  void around(const Vec3<double>& fraction, double radius, Meet&& meet) const {
    const auto s = components(fraction);
    const double reach = (radius + largest_) * (1 + 1e-12);  // margin for rounding: no particle may be missed
    Cells low, high;
    for (std::size_t a = 0; a < 3; ++a) {
      low[a] = bin(a, s[a] - reach / height_[a]);
      high[a] = bin(a, s[a] + reach / height_[a]);
    }
    Cells at, cells;
    for (std::int64_t x = low[0]; x <= high[0]; ++x)
      for (std::int64_t y = low[1]; y <= high[1]; ++y)
        for (std::int64_t z = low[2]; z <= high[2]; ++z) {
          const Cells wanted{x, y, z};
          for (std::size_t a = 0; a < 3; ++a) {
            cells[a] = (wanted[a] >= 0 ? wanted[a] : wanted[a] - count_[a] + 1) / count_[a];
            at[a] = wanted[a] - cells[a] * count_[a];
          }
          for (const std::uint32_t k : bins_[place(at)]) meet(k, cells);
        }
  }

 private:
  std::int64_t bin(std::size_t axis, double fraction) const {
    return static_cast<std::int64_t>(std::floor(fraction * static_cast<double>(count_[axis])));
  }
  std::size_t place(const Cells& at) const {
    return static_cast<std::size_t>((at[0] * count_[1] + at[1]) * count_[2] + at[2]);
  }

  double largest_ = 0;
  std::array<double, 3> height_{};
  Cells count_{};
  std::vector<std::vector<std::uint32_t>> bins_;
};

}  // namespace

std::vector<Overlap> find_overlaps(const Packing& p) {
  std::map<int, std::vector<std::uint32_t>> members;
  for (std::uint32_t k = 0; k < p.size(); ++k) members[octave(p.radius[k])].push_back(k);

  std::vector<Overlap> found;
  for (const auto& [size, smaller] : members) {
    const Grid grid(p, smaller);
    for (std::uint32_t i = 0; i < p.size(); ++i) {
      const int own = octave(p.radius[i]);
      if (own < size) continue;  // the search from the larger sphere finds this pair
      const Vec3<double> s = in_unit_cell(p.fraction[i]);
      grid.around(s, p.radius[i], [&, size = size](std::uint32_t j, const Cells& cells) {
        if (own == size && (j > i || (j == i && cells <= Cells{}))) return;
        // The integer fractions give the difference to the nearest image exactly; whole cells are added for
        // the wanted image.
        const Vec3<double> t = in_unit_cell(p.fraction[j]);
        Vec3<double> d = nearest_difference(p.fraction[i], p.fraction[j]);
        d.x += std::round(s.x - t.x - static_cast<double>(cells[0]) - d.x);
        d.y += std::round(s.y - t.y - static_cast<double>(cells[1]) - d.y);
        d.z += std::round(s.z - t.z - static_cast<double>(cells[2]) - d.z);
        const Vec3<double> branch = p.cell.edges * d;
        const double reach = p.radius[i] + p.radius[j];
        if (dot(branch, branch) < reach * reach) found.push_back({i, j, cells, branch});
      });
    }
  }
  return found;
}

}  // namespace furnas
