#include "engine/search/find_pairs.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <tuple>

#include "engine/base/parallel.h"
#include "engine/base/require.h"
#include "engine/search/neighbourhood.h"

namespace furnas {
namespace {

constexpr std::size_t chunk = 512;

/// Places in the cell are rounded to 2^-53 of it here, contacts are not: bins and reach are this much wider.
constexpr double hair = 1e-9;

struct Found {
  std::uint32_t partner;
  Vec3<double> difference;  ///< s_i - s_j of the image
  Quarter quarter;
};

Quarter quarters_of(const Vec3<double>& d) {
  require(4 * std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)}) < 127,
          "a sphere reaches across fewer than 30 cells");
  return {static_cast<std::int8_t>(std::nearbyint(4 * d.x)),
          static_cast<std::int8_t>(std::nearbyint(4 * d.y)),
          static_cast<std::int8_t>(std::nearbyint(4 * d.z))};
}

/// Of an image of a particle and its mirror image only one counts.
bool is_first_of_mirror(const Vec3<double>& k) { return std::tie(k.x, k.y, k.z) > std::tuple(0.0, 0.0, 0.0); }

/// Nearest images alone are right when no pair in reach can be met twice.
bool needs_images(const std::vector<SizeClass>& classes, const Skin& skin, const Triangle& edges) {
  const double radii = 2 * classes.front().largest_radius;
  const Vec3<double> h = heights(edges);
  return std::min({h.x, h.y, h.z}) < 2.1 * (radii + skin(radii));
}

/// The rows of one chunk of particles of a class, before they go to their places.
struct Piece {
  std::vector<Found> found;
  std::vector<std::pair<std::uint32_t, std::size_t>> owners;  ///< particle and the end of its rows
};

}  // namespace

std::vector<Bins> bin_classes(const std::vector<SizeClass>& classes, const Skin& skin, const Triangle& edges,
                              const std::vector<Fraction>& positions) {
  std::vector<Bins> bins;
  for (const SizeClass& c : classes) {
    const double radii = 2 * c.largest_radius;
    bins.push_back(sort_into_bins(edges, (1 + hair) * (radii + skin(radii)), positions, c.first, c.last));
  }
  return bins;
}

void find_pairs(const std::vector<Bins>& bins, const Triangle& edges, const std::vector<Fraction>& positions,
                const std::vector<double>& radii, PairList& list) {
  const std::size_t count = positions.size();
  list.edges = edges;
  list.reference = positions;
  list.first.assign(count + 1, 0);
  const bool images = needs_images(list.classes, list.skin, edges);

  std::vector<std::vector<Piece>> pieces(bins.size());
  for (std::size_t c = 0; c < bins.size(); ++c) {
    const std::vector<Binned>& seekers = bins[c].entries;
    pieces[c].resize((seekers.size() + chunk - 1) / chunk);
    for_chunks(seekers.size(), chunk, [&](std::size_t begin, std::size_t end, std::size_t number) {
      Piece& piece = pieces[c][number];
      std::vector<Neighbourhood> grids;
      for (std::size_t larger = 0; larger <= c; ++larger) grids.emplace_back(bins[larger]);
      for (std::size_t n = begin; n < end; ++n) {
        const Binned& me = seekers[n];
        const std::size_t start = piece.found.size();
        const auto visit = [&](const Binned& other, const Vec3<double>& image) {
          if (other.index > me.index || (other.index == me.index && !is_first_of_mirror(image))) return;
          const Vec3<double> difference = me.fraction - other.fraction - image;
          const Vec3<double> branch = edges * difference;
          const double sum = radii[me.index] + radii[other.index];
          const double reach = (1 + hair) * (sum + list.skin(sum));
          if (dot(branch, branch) < reach * reach)
            piece.found.push_back({other.index, difference, images ? quarters_of(difference) : Quarter{}});
        };
        for (Neighbourhood& grid : grids) grid.around(me.fraction, visit);
        std::sort(piece.found.begin() + static_cast<std::ptrdiff_t>(start), piece.found.end(),
                  [](const Found& a, const Found& b) {
                    return std::tie(a.partner, a.difference.x, a.difference.y, a.difference.z) <
                           std::tie(b.partner, b.difference.x, b.difference.y, b.difference.z);
                  });
        list.first[me.index + 1] = piece.found.size() - start;
        piece.owners.emplace_back(me.index, piece.found.size());
      }
    });
  }

  for (std::size_t i = 0; i < count; ++i) list.first[i + 1] += list.first[i];
  require(list.first[count] < std::numeric_limits<std::uint32_t>::max(), "rows of the list fit in 32 bits");
  list.partner.resize(list.first[count]);
  list.quarter.clear();
  if (images) list.quarter.resize(list.first[count]);
  for (std::vector<Piece>& row_of_pieces : pieces) {
    for_chunks(row_of_pieces.size(), 1, [&](std::size_t number, std::size_t, std::size_t) {
      const Piece& piece = row_of_pieces[number];
      std::size_t next = 0;
      for (const auto& [owner, end] : piece.owners) {
        for (std::uint64_t k = list.first[owner]; next < end; ++next, ++k) {
          list.partner[k] = piece.found[next].partner;
          if (images) list.quarter[k] = piece.found[next].quarter;
        }
      }
    });
  }
  index_incoming(list);
}

void index_incoming(PairList& list) {
  const std::size_t count = list.first.size() - 1;
  std::vector<std::atomic<std::uint64_t>> place(count + 1);
  for_chunks(list.rows(), 4096, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t k = begin; k < end; ++k)
      place[list.partner[k] + 1].fetch_add(1, std::memory_order_relaxed);
  });
  list.incoming_first.assign(count + 1, 0);
  for (std::size_t j = 0; j < count; ++j) {
    list.incoming_first[j + 1] = list.incoming_first[j] + place[j + 1];
    place[j] = list.incoming_first[j];
  }
  list.incoming.resize(list.rows());
  for_chunks(list.rows(), 4096, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t k = begin; k < end; ++k)
      list.incoming[place[list.partner[k]].fetch_add(1, std::memory_order_relaxed)] =
          static_cast<std::uint32_t>(k);
  });
  // Threads fill in any order; sorted, the order is that of the rows again.
  for_chunks(count, 1024, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t j = begin; j < end; ++j)
      std::sort(list.incoming.begin() + static_cast<std::ptrdiff_t>(list.incoming_first[j]),
                list.incoming.begin() + static_cast<std::ptrdiff_t>(list.incoming_first[j + 1]));
  });
}

}  // namespace furnas
