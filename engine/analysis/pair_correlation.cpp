#include "engine/analysis/pair_correlation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "engine/base/parallel.h"
#include "engine/base/require.h"
#include "engine/base/sphere.h"
#include "engine/search/grid.h"
#include "engine/state/species.h"

namespace furnas {
namespace {

using Counts = std::vector<std::int64_t>;

double shortest_height(const Packing& p) {
  const Vec3<double> h = heights(p.cell.edges);
  return std::min({h.x, h.y, h.z});
}

/// The particles of one species.
struct Group {
  std::vector<Fraction> places;
  double diameter = 0;     ///< mean [d_s]
  std::size_t stride = 1;  ///< distances are measured from every stride-th particle

  std::size_t size() const { return places.size(); }
  std::size_t origins() const { return (size() + stride - 1) / stride; }
  double weight() const { return static_cast<double>(size()) / static_cast<double>(origins()); }
};

std::array<Group, 2> groups_of(const Packing& p, double reach, double most_pairs) {
  std::array<Group, 2> groups;
  for (std::size_t k = 0; k < p.size(); ++k) {
    Group& group = groups[static_cast<std::size_t>(p.species[k])];
    group.places.push_back(p.fraction[k]);
    group.diameter += 2 * p.radius[k];
  }
  const double partners = static_cast<double>(p.size()) * sphere_volume(reach) / p.cell.volume();
  for (Group& group : groups) {
    if (group.size() == 0) continue;
    group.diameter /= static_cast<double>(group.size());
    const double pairs = static_cast<double>(group.size()) * partners;
    group.stride = static_cast<std::size_t>(std::max(1.0, std::ceil(pairs / most_pairs)));
  }
  return groups;
}

/// Histogram of the distances from the origins of one group to all particles of another.
Counts count_distances(const Triangle& edges, const Group& from, const Group& to, bool same, double reach,
                       double width, std::size_t bins) {
  // Positions are rounded to 2^-53 of the cell. No particle may be missed because of this rounding.
  constexpr double tolerance = 1e-9;
  const Vec3<double> faces = heights(edges);
  const double itself = tolerance * std::min({faces.x, faces.y, faces.z});  // nearer than any image
  const Grid grid = make_grid(edges, (1 + tolerance) * reach, to.places, 0, to.size());
  constexpr std::size_t most_chunks = 64;
  const std::size_t size = from.origins() / most_chunks + 1;
  std::vector<Counts> parts((from.origins() + size - 1) / size);
  for_chunks(from.origins(), size, [&](std::size_t begin, std::size_t end, std::size_t chunk) {
    Counts& counts = parts[chunk];
    counts.resize(bins);
    for (std::size_t n = begin; n < end; ++n) {
      const std::size_t me = n * from.stride;
      const Vec3<double> here = in_unit_cell(from.places[me]);
      visit_ball(grid, edges, here, grid.cutoff,
                 [&](const Placed* at, const Placed* last, const Vec3<double>& image) {
                   for (; at < last; ++at) {
                     const double distance = norm(edges * (at->fraction + image - here));
                     if (same && at->index == me && distance < itself) continue;
                     const auto bin = static_cast<std::size_t>(distance / width);
                     if (bin < bins) ++counts[bin];
                   }
                 });
    }
  });
  Counts sum(bins);
  for (const Counts& part : parts)
    for (std::size_t b = 0; b < bins; ++b) sum[b] += part[b];
  return sum;
}

/// Adds `merged` bins each to one.
Counts coarser(const Counts& fine, std::size_t merged) {
  Counts coarse(fine.size() / merged);
  for (std::size_t b = 0; b < coarse.size() * merged; ++b) coarse[b / merged] += fine[b];
  return coarse;
}

/// Number of pairs in the shell of a bin that an ideal gas has: volume of the shell times the density of
/// pairs, where each origin has `partners` possible partners.
double expected_pairs(const PairCorrelation& found, std::size_t bin, double partners, double volume) {
  return static_cast<double>(found.origins) * partners / volume *
         (sphere_volume(found.edges[bin + 1]) - sphere_volume(found.edges[bin]));
}

void lay_edges(PairCorrelation& found, double width) {
  for (std::size_t b = 0; b <= found.counts.size(); ++b)
    found.edges.push_back(static_cast<double>(b) * width);
}

PairCorrelation of_one_kind(std::optional<PairKind> kind, const Group& from, const Group& to, Counts counts,
                            double width, double volume) {
  PairCorrelation found;
  found.kind = kind;
  found.contact = 0.5 * (from.diameter + to.diameter);
  found.origins = static_cast<std::int64_t>(from.origins());
  found.counts = std::move(counts);
  lay_edges(found, width);
  const bool same = &from == &to;
  const auto partners = static_cast<double>(to.size());
  // A pair of two origins of one species was counted from both of its particles.
  const double spread = same ? 1 + 1 / from.weight() : 1;
  double met = 0;
  for (std::size_t b = 0; b < found.counts.size(); ++b) {
    const auto count = static_cast<double>(found.counts[b]);
    const double expected = expected_pairs(found, b, partners, volume);
    met += count;
    found.g.push_back(count / expected);
    found.error.push_back(std::sqrt(count * spread) / expected);
    found.neighbours.push_back(met / static_cast<double>(found.origins));
  }
  return found;
}

/// g(r) of all particles, from the counts large-large, large-small and small-small in the same bins.
PairCorrelation of_all(const std::array<Group, 2>& groups, const std::array<Counts, 3>& counts, double width,
                       double volume) {
  const auto& [large, small] = groups;
  // Large-small pairs were counted from the large particle only, hence the factor 2. Counts from every
  // stride-th origin are multiplied by the stride.
  const double weights[] = {large.weight(), 2 * large.weight(), small.weight()};
  const double spreads[] = {1 + 1 / large.weight(), 1, 1 + 1 / small.weight()};
  const auto particles = static_cast<double>(large.size() + small.size());
  PairCorrelation found;
  found.contact = (static_cast<double>(large.size()) * large.diameter +
                   static_cast<double>(small.size()) * small.diameter) /
                  particles;
  found.origins = static_cast<std::int64_t>(large.origins() + small.origins());
  found.counts.resize(counts[0].size());
  lay_edges(found, width);
  double met = 0;
  for (std::size_t b = 0; b < found.counts.size(); ++b) {
    double pairs = 0, variance = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto count = static_cast<double>(counts[k][b]);
      found.counts[b] += counts[k][b];
      pairs += weights[k] * count;
      variance += weights[k] * weights[k] * spreads[k] * count;
    }
    const double expected =
        particles * particles / volume * (sphere_volume(found.edges[b + 1]) - sphere_volume(found.edges[b]));
    met += pairs;
    found.g.push_back(pairs / expected);
    found.error.push_back(std::sqrt(variance) / expected);
    found.neighbours.push_back(met / particles);
  }
  return found;
}

void check(const Packing& p, double reach, double bin) {
  constexpr double most_cells = 10, most_bins = 1e5;
  if (!(reach > 0) || reach > most_cells * shortest_height(p))
    throw InputError("the reach of g(r) is " + std::to_string(reach) +
                     " d_s; allowed: above 0, up to ten times " + std::to_string(shortest_height(p)) +
                     " d_s, the smallest height of the cell");
  if (!(bin > 0) || bin > reach || reach / bin > most_bins)
    throw InputError("the bins of g(r) are " + std::to_string(bin) +
                     " d_s wide; allowed: a hundred-thousandth of the reach, " + std::to_string(reach) +
                     " d_s, up to all of it");
}

}  // namespace

double chosen_reach(const Packing& p) {
  if (p.size() == 0) return 0;
  const double large = 2 * *std::max_element(p.radius.begin(), p.radius.end());
  return std::clamp(0.5 * shortest_height(p), 2.5 * large, 5 * large);
}

std::vector<PairCorrelation> pair_correlation(const Packing& p, const PairCorrelationOptions& options) {
  const double reach = options.reach > 0 ? options.reach : chosen_reach(p);
  if (p.size() == 0) return {};
  check(p, reach, options.bin);
  const std::array<Group, 2> groups = groups_of(p, reach, options.most_pairs);
  const double volume = p.cell.volume();
  const auto bins = static_cast<std::size_t>(std::floor(reach / options.bin * (1 + 1e-12)));
  const double smallest = std::min(groups[0].size() > 0 ? groups[0].diameter : INFINITY,
                                   groups[1].size() > 0 ? groups[1].diameter : INFINITY);
  const bool no_kinds = is_one_polydisperse_species(p);
  std::array<Counts, 3> counts;
  std::vector<PairCorrelation> all;
  for (const PairKind kind : pair_kinds) {
    const Group& from = groups[kind == PairKind::small_small ? 1 : 0];
    const Group& to = groups[kind == PairKind::large_large ? 0 : 1];
    const bool same = &from == &to;
    Counts& fine = counts[static_cast<std::size_t>(kind)];
    fine.resize(bins);
    if (from.size() == 0 || to.size() == 0) continue;
    fine = count_distances(p.cell.edges, from, to, same, reach, options.bin, bins);
    const auto merged =
        static_cast<std::size_t>(std::max(1.0, std::floor(0.5 * (from.diameter + to.diameter) / smallest)));
    all.push_back(of_one_kind(no_kinds ? std::nullopt : std::optional(kind), from, to,
                              coarser(fine, std::min(merged, bins)),
                              static_cast<double>(std::min(merged, bins)) * options.bin, volume));
  }
  if (groups[0].size() > 0 && groups[1].size() > 0)
    all.push_back(of_all(groups, counts, options.bin, volume));
  return all;
}

}  // namespace furnas
