#include "engine/search/find_pairs.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "engine/base/counting_sort.h"
#include "engine/base/parallel.h"
#include "engine/base/refill.h"
#include "engine/base/require.h"

namespace furnas {
namespace {

/// Positions are rounded here to 2^-53 of the cell, but not when forces are computed. Therefore bins and
/// reach are wider by this share.
constexpr double tolerance = 1e-9;

constexpr std::size_t chunk = 512;  ///< particles

/// A partner and its image as one number, so that rows are sorted by partner, then by image. The partner is
/// in the upper half, the quarters, shifted to positive values, in the lower half.
struct Found {
  std::uint64_t key;
  Found(std::uint32_t partner, const Quarter& q)
      : key(std::uint64_t{partner} << 32 | part(q[0]) << 16 | part(q[1]) << 8 | part(q[2])) {}
  Found() = default;
  std::uint32_t partner() const { return static_cast<std::uint32_t>(key >> 32); }
  Quarter quarter() const { return {quarter(16), quarter(8), quarter(0)}; }
  bool operator<(const Found& b) const { return key < b.key; }

 private:
  static std::uint64_t part(std::int8_t q) { return static_cast<std::uint64_t>(q + 128); }
  std::int8_t quarter(int shift) const {
    return static_cast<std::int8_t>(static_cast<int>(key >> shift & 255) - 128);
  }
};

/// A particle and a partner of a larger class.
struct Across {
  std::uint32_t particle;
  Found found;
};

Quarter quarters_of(const Vec3<double>& d) {
  require(4 * std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)}) < 127,
          "a sphere reaches across fewer than 30 cells");
  return {static_cast<std::int8_t>(std::nearbyint(4 * d.x)),
          static_cast<std::int8_t>(std::nearbyint(4 * d.y)),
          static_cast<std::int8_t>(std::nearbyint(4 * d.z))};
}

/// A particle and its own image form the same pair as the particle and the opposite image. Only one of the
/// two counts.
bool is_first_of_mirror(const Vec3<double>& k) { return std::tie(k.x, k.y, k.z) > std::tuple(0.0, 0.0, 0.0); }

/// Whether rows must store images. If no pair can be in reach in two images, the nearest image is always the
/// right one.
bool needs_images(const std::vector<SizeClass>& classes, const Skin& skin, const Triangle& edges) {
  const double radii = 2 * classes.front().largest_radius;
  const Vec3<double> h = heights(edges);
  return std::min({h.x, h.y, h.z}) < 2.1 * (radii + skin(radii));
}

/// The criterion by which two particles are a pair of the list.
class Nearness {
 public:
  Nearness(const Triangle& edges, const std::vector<double>& radii, const Skin& skin, bool images)
      : edges_(edges), radii_(radii), skin_(skin), images_(images) {}

  /// Whether particles i and j with this difference of positions are listed. `most` is an upper bound of
  /// their reach.
  bool operator()(std::uint32_t i, std::uint32_t j, const Vec3<double>& difference, double most) const {
    const Vec3<double> branch = edges_ * difference;
    const double square = dot(branch, branch);
    if (square >= most * most) return false;
    const double sum = radii_[i] + radii_[j];
    const double reach = (1 + tolerance) * (sum + skin_(sum));
    return square < reach * reach;
  }
  const Triangle& edges() const { return edges_; }
  double radius(std::size_t i) const { return radii_[i]; }
  Found found(std::uint32_t partner, const Vec3<double>& difference) const {
    return {partner, images_ ? quarters_of(difference) : Quarter{}};
  }

 private:
  const Triangle& edges_;
  const std::vector<double>& radii_;
  const Skin& skin_;
  bool images_;
};

/// The particles of several runs of bins in one array.
class Gathered {
 public:
  /// Removes all particles.
  void clear() { count_ = 0; }

  /// Adds a run. A loop over its few particles would cost a mispredicted branch, so four particles are copied
  /// at once; the next run overwrites the surplus.
  void add(const Placed* at, const Placed* end) {
    const auto more = static_cast<std::size_t>(end - at);
    if (room_.size() < count_ + more + Grid::spare) room_.resize(2 * (count_ + more + Grid::spare));
    Placed* to = room_.data() + count_;
    do {
      for (std::size_t k = 0; k < Grid::spare; ++k) to[k] = at[k];
      at += Grid::spare, to += Grid::spare;
    } while (at < end);
    count_ += more;
  }

  /// Keeps the particles that come before `i` and are less than `reach` away from `s`.
  void keep_near(std::uint32_t i, const Vec3<double>& s, const Triangle& edges, double reach) {
    std::size_t kept = 0;
    for (std::size_t n = 0; n < count_; ++n) {
      const Vec3<double> branch = edges * (s - room_[n].fraction);
      // Both conditions are always evaluated, to avoid a branch.
      const int near =
          static_cast<int>(room_[n].index < i) & static_cast<int>(dot(branch, branch) < reach * reach);
      room_[kept] = room_[n];
      kept += static_cast<std::size_t>(near);
    }
    count_ = kept;
  }

  const Placed* begin() const { return room_.data(); }
  const Placed* end() const { return room_.data() + count_; }

 private:
  std::size_t count_ = 0;
  std::vector<Placed> room_;
};

/// Appends the partners of particle `i` that are in its own class and come before it in memory.
void find_equals(const Grid& grid, const Vec3<double>& height, const Nearness& near, std::uint32_t i,
                 const Vec3<double>& s, Gathered& inside, std::vector<Found>& found) {
  const auto reach = [&](int axis, double h) {
    return static_cast<std::int64_t>(std::ceil(grid.cutoff * static_cast<double>(grid.count[axis]) / h));
  };
  const std::int64_t rx = reach(0, height.x);
  const std::int64_t ry = reach(1, height.y);
  const std::int64_t rz = reach(2, height.z);
  const std::int64_t x = grid.coordinate(0, s.x);
  const std::int64_t y = grid.coordinate(1, s.y);
  const std::int64_t z = grid.coordinate(2, s.z);
  const auto take = [&](const Placed& other, const Vec3<double>& image) {
    const Vec3<double> difference = s - other.fraction - image;
    if (near(i, other.index, difference, grid.cutoff)) found.push_back(near.found(other.index, difference));
  };
  inside.clear();
  const auto visit = [&](const Placed* at, const Placed* end, const Vec3<double>& image) {
    if (image == Vec3<double>{}) return inside.add(at, end);
    for (; at != end; ++at)
      if (at->index < i || (at->index == i && is_first_of_mirror(image))) take(*at, image);
  };
  for (std::int64_t c = z - rz; c <= z + rz; ++c)
    for (std::int64_t b = y - ry; b <= y + ry; ++b)
      visit_run(grid, x - rx, x + rx, wrapped(b, grid.count[1]), wrapped(c, grid.count[2]), visit);
  inside.keep_near(i, s, near.edges(), grid.cutoff);
  for (const Placed& other : inside) take(other, {});
}

/// Appends the particles of the smaller class on `grid` that are near particle `j` of a larger one.
void find_smaller(const Grid& grid, const Triangle& edges, const Nearness& near, double reach,
                  std::uint32_t j, const Vec3<double>& s, std::vector<Across>& found) {
  visit_ball(grid, edges, s, reach, [&](const Placed* at, const Placed* end, const Vec3<double>& image) {
    for (; at != end; ++at) {
      const Vec3<double> difference = at->fraction + image - s;
      if (near(at->index, j, difference, reach)) found.push_back({at->index, near.found(j, difference)});
    }
  });
}

/// All pairs of particles of different classes, in pieces of `few` larger particles.
std::vector<std::vector<Across>> find_across(const std::vector<Grid>& grids, const Triangle& edges,
                                             const Nearness& near, const PairList& list) {
  const std::size_t larger = list.classes.back().first;  // particles before the smallest class
  constexpr std::size_t few = 4;  // few, because a large sphere may have thousands of partners
  std::vector<std::vector<Across>> pieces((larger + few - 1) / few);
  for_chunks(larger, few, [&](std::size_t begin, std::size_t end, std::size_t piece) {
    for (std::size_t j = begin; j < end; ++j)
      for (std::size_t c = 0; c < grids.size(); ++c) {
        if (list.classes[c].first <= j) continue;  // class c is that of j, or larger
        const double sum = list.classes[c].largest_radius + near.radius(j);
        find_smaller(grids[c], edges, near, (1 + 2 * tolerance) * (sum + list.skin(sum)),
                     static_cast<std::uint32_t>(j), in_unit_cell(list.reference[j]), pieces[piece]);
      }
  });
  return pieces;
}

/// The rows of one chunk of particles within their classes.
struct Piece {
  std::vector<Found> found;
  std::vector<std::uint32_t> count;  ///< rows of each particle
};

std::vector<Piece> find_within(const std::vector<Grid>& grids, const Triangle& edges, const Nearness& near,
                               const PairList& list) {
  const std::vector<Fraction>& positions = list.reference;
  const Vec3<double> height = heights(edges);
  std::vector<Piece> pieces((positions.size() + chunk - 1) / chunk);
  for_chunks(positions.size(), chunk, [&](std::size_t begin, std::size_t end, std::size_t number) {
    Piece& piece = pieces[number];
    piece.found.reserve(5 * chunk);
    piece.count.reserve(chunk);
    Gathered inside;
    std::size_t c = 0;
    for (std::size_t i = begin; i < end; ++i) {
      while (list.classes[c].last <= i) ++c;
      const std::size_t before = piece.found.size();
      find_equals(grids[c], height, near, static_cast<std::uint32_t>(i), in_unit_cell(positions[i]), inside,
                  piece.found);
      std::sort(piece.found.begin() + static_cast<std::ptrdiff_t>(before), piece.found.end());
      piece.count.push_back(static_cast<std::uint32_t>(piece.found.size() - before));
    }
  });
  return pieces;
}

/// Collects the rows of each particle. Partners of larger classes come first, because they come first in
/// memory.
void lay_out_rows(const std::vector<std::vector<Across>>& across, const std::vector<Piece>& within,
                  bool images, PairList& list) {
  const std::size_t count = list.reference.size();
  std::vector<std::atomic<std::uint32_t>> larger(count);
  for_chunks(across.size(), 1, [&](std::size_t piece, std::size_t, std::size_t) {
    for (const Across& a : across[piece]) larger[a.particle].fetch_add(1, std::memory_order_relaxed);
  });
  refill(list.first, count + 1);
  std::uint64_t rows = 0;
  for (std::size_t i = 0; i < count; ++i) {
    list.first[i] = static_cast<RowNumber>(rows);
    rows += within[i / chunk].count[i % chunk] + larger[i].load(std::memory_order_relaxed);
  }
  require(rows < std::numeric_limits<RowNumber>::max(), "rows of the list fit in 32 bits");
  list.first[count] = static_cast<RowNumber>(rows);

  refill(list.partner, rows);
  refill(list.quarter, images ? rows : 0);
  const auto put = [&](std::uint64_t row, const Found& found) {
    list.partner[row] = found.partner();
    if (images) list.quarter[row] = found.quarter();
  };
  for_chunks(across.size(), 1, [&](std::size_t piece, std::size_t, std::size_t) {
    for (const Across& a : across[piece])
      put(list.first[a.particle] + larger[a.particle].fetch_sub(1, std::memory_order_relaxed) - 1, a.found);
  });
  for_chunks(within.size(), 1, [&](std::size_t piece, std::size_t, std::size_t) {
    const Found* from = within[piece].found.data();
    std::vector<Found> larger_ones;
    for (std::size_t n = 0; n < within[piece].count.size(); ++n) {
      const std::size_t i = piece * chunk + n;
      const std::uint64_t own = list.first[i + 1] - within[piece].count[n];
      // The threads have written the partners of larger classes in any order; here they are sorted.
      larger_ones.clear();
      for (std::uint64_t row = list.first[i]; row < own; ++row)
        larger_ones.emplace_back(list.partner[row], images ? list.quarter[row] : Quarter{});
      std::sort(larger_ones.begin(), larger_ones.end());
      for (std::size_t k = 0; k < larger_ones.size(); ++k) put(list.first[i] + k, larger_ones[k]);
      for (std::uint64_t row = own; row < list.first[i + 1]; ++row) put(row, *from++);
    }
  });
}

}  // namespace

std::vector<Grid> bin_classes(const std::vector<SizeClass>& classes, const Skin& skin, const Triangle& edges,
                              const std::vector<Fraction>& positions, std::vector<Grid> former) {
  std::vector<Grid> grids = std::move(former);
  grids.resize(classes.size());
  for (std::size_t n = 0; n < classes.size(); ++n) {
    const SizeClass& c = classes[n];
    const double radii = 2 * c.largest_radius;
    grids[n] = make_grid(edges, (1 + 2 * tolerance) * (radii + skin(radii)), positions, c.first, c.last,
                         std::move(grids[n]));
  }
  return grids;
}

void find_pairs(const std::vector<Grid>& grids, const Triangle& edges, const std::vector<double>& radii,
                PairList& list) {
  list.edges = edges;
  const bool images = needs_images(list.classes, list.skin, edges);
  const Nearness near(edges, radii, list.skin, images);
  lay_out_rows(find_across(grids, edges, near, list), find_within(grids, edges, near, list), images, list);
  index_incoming(list);
}

void index_incoming(PairList& list) {
  const std::size_t count = list.first.size() - 1;
  refill(list.incoming, list.rows());
  counting_sort(
      list.rows(), count, list.incoming_first, [&](std::size_t k) { return list.partner[k]; },
      [&](std::size_t place, std::size_t k) { list.incoming[place] = static_cast<RowNumber>(k); });
  // The threads write in any order; sorting restores the order of the rows.
  for_chunks(count, 1024, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t j = begin; j < end; ++j)
      std::sort(list.incoming.begin() + static_cast<std::ptrdiff_t>(list.incoming_first[j]),
                list.incoming.begin() + static_cast<std::ptrdiff_t>(list.incoming_first[j + 1]));
  });
}

}  // namespace furnas
