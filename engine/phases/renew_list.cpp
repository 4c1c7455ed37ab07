#include "engine/phases/renew_list.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/base/parallel.h"
#include "engine/search/find_pairs.h"
#include "engine/search/merge.h"
#include "engine/search/near_rows.h"

namespace furnas {

void watch_wear(const std::int64_t& step, const LongestWay& longest_way, const Cell& cell,
                const PairList& pairs, Wear& wear) {
  for (std::size_t c = 0; c < longest_way.size(); ++c) wear.travelled[c] += std::sqrt(longest_way[c]);
  wear.suspect = is_time_to_ask(pairs, step) ||
                 !list_is_complete(pairs, wear.travelled, shrinkage_bound(cell.edges, pairs.edges));
}

template <class Scene>
void measure_wear(const std::optional<double>& skin, const std::int64_t& step, const Cell& cell,
                  const PairList& pairs,
                  const std::vector<Particle<typename Scene::Real, Scene::spins>>& particles, Wear& wear) {
  for (std::size_t c = 0; c < pairs.classes.size(); ++c) {
    const SizeClass& group = pairs.classes[c];
    struct Furthest {
      double square{};
      void operator+=(const Furthest& b) { square = std::max(square, b.square); }
    };
    const auto furthest =
        ordered_sum<Furthest>(group.last - group.first, 1024, [&](std::size_t begin, std::size_t end) {
          Furthest piece;
          for (std::size_t i = group.first + begin; i < group.first + end; ++i) {
            const Vec3<double> way =
                pairs.edges * nearest_difference(particles[i].position, pairs.reference[i]);
            piece += {dot(way, way)};
          }
          return piece;
        });
    wear.travelled[c] = std::sqrt(furthest.square);
  }
  const double shrunk = shrinkage(cell.edges, pairs.edges);
  wear.worn = !list_is_complete(pairs, wear.travelled, shrunk) ||
              is_too_wide(pairs, wear.travelled, shrunk, step, skin);
}

template <class Scene>
void bin_particles(const std::optional<double>& skin, const std::int64_t& step, const Cell& cell,
                   const Wear& wear, const PairList& pairs,
                   const std::vector<Particle<typename Scene::Real, Scene::spins>>& particles,
                   ListDraft& draft) {
  std::vector<Fraction>& positions = draft.fresh.reference;
  positions.resize(particles.size());
  draft.radii.resize(particles.size());
  for_chunks(particles.size(), 1024, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t i = begin; i < end; ++i) {
      positions[i] = particles[i].position;
      draft.radii[i] = particles[i].radius;
    }
  });
  draft.fresh.classes = pairs.classes;
  draft.fresh.skin =
      next_skin(pairs, wear.travelled, pairs.builds > 0 ? shrinkage(cell.edges, pairs.edges) : 0, step, skin);
  draft.grids = bin_classes(draft.fresh.classes, draft.fresh.skin, cell.edges, positions);
}

void search_pairs(const Cell& cell, ListDraft& draft) {
  find_pairs(draft.grids, cell.edges, draft.radii, draft.fresh);
}

template <class Scene>
void adopt_list(const std::int64_t& step, ListDraft& draft, PairList& pairs,
                Rows<typename Scene::Real, Scene::spins>& rows, Memory<typename Scene::Real>& memory,
                std::vector<Image>& image, Wear& wear) {
  const std::vector<Fraction>& positions = draft.fresh.reference;
  for_chunks(pairs.reference.size(), 1024, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t i = begin; i < end; ++i) image[i] = crossed(image[i], pairs.reference[i], positions[i]);
  });
  merge_memory(pairs, memory, draft.fresh, positions, Scene::spins);
  draft.fresh.step = step;
  draft.fresh.builds = pairs.builds + 1;
  pairs = std::move(draft.fresh);
  draft = {};  // of many particles it takes much memory, of few no time
  rows.assign(pairs.rows(), {});
  wear.travelled.assign(pairs.classes.size(), 0);
  wear.suspect = wear.worn = false;
}

void watch_near_rows(const std::int64_t& step, const double& time_step, const LongestWay& longest_way,
                     const Cell& cell, const PairList& pairs, NearRows& near) {
  if (near.builds == pairs.builds) {
    if (near.kept) {
      // Ways are measured in the cell of the list.
      const double stretch = 1 + strain_between(pairs.edges, near.edges);
      for (std::size_t c = 0; c < longest_way.size(); ++c)
        near.travelled[c] += stretch * std::sqrt(longest_way[c]);
      near.worn = !rows_are_complete(pairs.classes, near.skin, near.edges, near.travelled,
                                     shrinkage_bound(cell.edges, near.edges));
    }
    if (!near.worn || (!near.kept && !is_time_to_ask(pairs, step))) return;
  }
  near.builds = pairs.builds;
  near.worn = true;
  near.edges = cell.edges;
  near.travelled.assign(pairs.classes.size(), 0);
  double motion = 0;
  for (double square : longest_way) motion = std::max(motion, 2 * std::sqrt(square));
  const Triangle& e = cell.rate;
  const double strain = time_step * std::hypot(std::hypot(e.xx, e.yy, e.zz), std::hypot(e.yz, e.xz, e.xy));
  choose_near_skin(pairs, motion, strain, near);
}

#define FURNAS_INSTANTIATE(Law, Real)                                                                        \
  template void measure_wear<Scene<Law, Real>>(const std::optional<double>&, const std::int64_t&,            \
                                               const Cell&, const PairList&,                                 \
                                               const std::vector<Particle<Real, Law::spins>>&, Wear&);       \
  template void bin_particles<Scene<Law, Real>>(const std::optional<double>&, const std::int64_t&,           \
                                                const Cell&, const Wear&, const PairList&,                   \
                                                const std::vector<Particle<Real, Law::spins>>&, ListDraft&); \
  template void adopt_list<Scene<Law, Real>>(const std::int64_t&, ListDraft&, PairList&,                     \
                                             Rows<Real, Law::spins>&, Memory<Real>&, std::vector<Image>&,    \
                                             Wear&);
FURNAS_FOR_EACH_SCENE(FURNAS_INSTANTIATE)
#undef FURNAS_INSTANTIATE

}  // namespace furnas
