#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "engine/search/bins.h"

namespace furnas {

/// A bin along one edge, wrapped into the cell. Divides once, then only counts: a division a bin would
/// take a fifth of the time of the search.
struct WrappedBin {
  std::int64_t count;  ///< bins along the edge
  std::int64_t cell;   ///< cells to the right of the first
  std::int64_t index;  ///< in [0, count)

  WrappedBin(std::int64_t bin, std::int64_t bins)
      : count(bins), cell((bin >= 0 ? bin : bin - bins + 1) / bins), index(bin - cell * bins) {}
  void next() {
    if (++index == count) index = 0, ++cell;
  }
};

/// A place in the sorted entries that remembers where it was: successive particles ask for nearby keys.
class Cursor {
 public:
  /// First entry whose key is not below `key`.
  const Binned* seek(const std::vector<Binned>& entries, std::uint64_t key) {
    constexpr int patience = 8;
    const Binned* const begin = entries.data();
    const Binned* const end = begin + entries.size();
    if (!at_ || (at_ != begin && at_[-1].key >= key)) return at_ = lower_bound(begin, end, key);
    for (int n = 0; n < patience; ++n, ++at_)
      if (at_ == end || at_->key >= key) return at_;
    return at_ = lower_bound(at_, end, key);
  }

 private:
  static const Binned* lower_bound(const Binned* begin, const Binned* end, std::uint64_t key) {
    return std::lower_bound(begin, end, key, [](const Binned& b, std::uint64_t k) { return b.key < k; });
  }
  const Binned* at_ = nullptr;
};

/// Calls visit(entry, image) for each entry in the bins around a point, image by image.
class Neighbourhood {
 public:
  explicit Neighbourhood(const Bins& bins)
      : bins_(bins),
        cursors_(static_cast<std::size_t>((2 * bins.reach[0] + 1) * (2 * bins.reach[1] + 1) * 3)) {}

  template <class Visit>
  void around(const Vec3<double>& s, Visit&& visit) {
    const auto& [nx, ny, nz] = bins_.count;
    const auto& [rx, ry, rz] = bins_.reach;
    const std::int64_t cz = bins_.coordinate(2, s.z);
    const WrappedBin first_y(bins_.coordinate(1, s.y) - ry, ny);
    const WrappedBin first_z(cz - rz, nz);
    const WrappedBin last_z(cz + rz, nz);
    const Binned* const end = bins_.entries.data() + bins_.entries.size();
    std::size_t column = 0;
    WrappedBin x(bins_.coordinate(0, s.x) - rx, nx);
    for (std::int64_t across = -rx; across <= rx; ++across, x.next()) {
      WrappedBin y = first_y;
      for (std::int64_t along = -ry; along <= ry; ++along, y.next(), ++column) {
        for (std::int64_t kz = first_z.cell; kz <= last_z.cell; ++kz) {
          const std::int64_t low = kz == first_z.cell ? first_z.index : 0;
          const std::int64_t high = kz == last_z.cell ? last_z.index : nz - 1;
          const std::uint64_t to = bins_.key(x.index, y.index, high);
          const Vec3<double> image{static_cast<double>(x.cell), static_cast<double>(y.cell),
                                   static_cast<double>(kz)};
          Cursor& cursor = cursors_[3 * column + static_cast<std::size_t>((kz % 3 + 3) % 3)];
          for (const Binned* e = cursor.seek(bins_.entries, bins_.key(x.index, y.index, low));
               e != end && e->key <= to; ++e)
            visit(*e, image);
        }
      }
    }
  }

 private:
  const Bins& bins_;
  std::vector<Cursor> cursors_;
};

}  // namespace furnas
