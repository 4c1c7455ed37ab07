#include "engine/phases/renew_list.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/base/parallel.h"
#include "engine/search/find_pairs.h"
#include "engine/search/inner_skin.h"
#include "engine/search/merge.h"

namespace furnas {

void add_displacement(const std::int64_t& step, const SquaredDisplacement& squared_displacement,
                      const Cell& cell, const PairList& pairs, ListDisplacement& displacement) {
  for (std::size_t c = 0; c < squared_displacement.size(); ++c)
    displacement.largest[c] += std::sqrt(squared_displacement[c]);
  displacement.suspect =
      is_time_to_ask(pairs, step) ||
      !list_is_complete(pairs, displacement.largest, shrinkage_bound(pairs.edges, cell.edges));
}

template <class Numerics>
void measure_displacement(const std::optional<double>& skin, const std::int64_t& step, const Cell& cell,
                          const PairList& pairs,
                          const std::vector<Particle<typename Numerics::Real, Numerics::spins>>& particles,
                          ListDisplacement& displacement) {
  for (std::size_t c = 0; c < pairs.classes.size(); ++c) {
    const SizeClass& group = pairs.classes[c];
    const auto square =
        ordered_sum<Largest>(group.last - group.first, 1024, [&](std::size_t begin, std::size_t end) {
          Largest piece;
          for (std::size_t i = group.first + begin; i < group.first + end; ++i) {
            const Vec3<double> moved =
                pairs.edges * nearest_difference(particles[i].position, pairs.reference[i]);
            piece += {dot(moved, moved)};
          }
          return piece;
        });
    displacement.largest[c] = std::sqrt(square.value);
  }
  const double shrunk = shrinkage(pairs.edges, cell.edges);
  displacement.outdated = !list_is_complete(pairs, displacement.largest, shrunk) ||
                          is_too_wide(pairs, displacement.largest, shrunk, step, skin);
}

template <class Numerics>
void bin_particles(const std::optional<double>& skin, const std::int64_t& step, const Cell& cell,
                   const ListDisplacement& displacement, const PairList& pairs,
                   const std::vector<Particle<typename Numerics::Real, Numerics::spins>>& particles,
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
  draft.fresh.skin = next_skin(pairs, displacement.largest,
                               pairs.builds > 0 ? shrinkage(pairs.edges, cell.edges) : 0, step, skin);
  draft.grids = bin_classes(draft.fresh.classes, draft.fresh.skin, cell.edges, positions);
}

void search_pairs(const Cell& cell, ListDraft& draft) {
  find_pairs(draft.grids, cell.edges, draft.radii, draft.fresh);
}

template <class Numerics>
void adopt_list(const std::int64_t& step, ListDraft& draft, PairList& pairs,
                Rows<typename Numerics::Real, Numerics::spins>& rows,
                ContactState<typename Numerics::Real>& contact_state, std::vector<Image>& image,
                ListDisplacement& displacement) {
  const std::vector<Fraction>& positions = draft.fresh.reference;
  for_chunks(pairs.reference.size(), 1024, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t i = begin; i < end; ++i) image[i] = crossed(image[i], pairs.reference[i], positions[i]);
  });
  merge_contact_state(pairs, contact_state, draft.fresh, positions, Numerics::spins);
  draft.fresh.step = step;
  draft.fresh.builds = pairs.builds + 1;
  pairs = std::move(draft.fresh);
  draft = {};  // frees much memory for many particles; for few, costs no time
  rows.assign(pairs.rows(), {});
  displacement.largest.assign(pairs.classes.size(), 0);
  displacement.suspect = displacement.outdated = false;
}

void watch_inner_list(const std::int64_t& step, const double& time_step,
                      const SquaredDisplacement& squared_displacement, const Cell& cell,
                      const PairList& pairs, InnerList& inner) {
  if (inner.builds == pairs.builds) {
    if (inner.kept) {
      // squared_displacement is measured in the cell at the build of the neighbour list.
      const double stretch = 1 + strain_between(pairs.edges, inner.edges);
      for (std::size_t c = 0; c < squared_displacement.size(); ++c)
        inner.displacement[c] += stretch * std::sqrt(squared_displacement[c]);
      inner.outdated = !rows_are_complete(pairs.classes, inner.skin, inner.edges, inner.displacement,
                                          shrinkage_bound(inner.edges, cell.edges));
    }
    if (!inner.outdated || (!inner.kept && !is_time_to_ask(pairs, step))) return;
  }
  inner.builds = pairs.builds;
  inner.outdated = true;
  inner.edges = cell.edges;
  inner.displacement.assign(pairs.classes.size(), 0);
  double motion = 0;
  for (double square : squared_displacement) motion = std::max(motion, 2 * std::sqrt(square));
  const Triangle& e = cell.rate;
  const double strain = time_step * std::hypot(std::hypot(e.xx, e.yy, e.zz), std::hypot(e.yz, e.xz, e.xy));
  choose_inner_skin(pairs, motion, strain, inner);
}

#define FURNAS_INSTANTIATE(Law, Real)                                                          \
  template void measure_displacement<Numerics<Law, Real>>(                                     \
      const std::optional<double>&, const std::int64_t&, const Cell&, const PairList&,         \
      const std::vector<Particle<Real, Law::spins>>&, ListDisplacement&);                      \
  template void bin_particles<Numerics<Law, Real>>(                                            \
      const std::optional<double>&, const std::int64_t&, const Cell&, const ListDisplacement&, \
      const PairList&, const std::vector<Particle<Real, Law::spins>>&, ListDraft&);            \
  template void adopt_list<Numerics<Law, Real>>(const std::int64_t&, ListDraft&, PairList&,    \
                                                Rows<Real, Law::spins>&, ContactState<Real>&,  \
                                                std::vector<Image>&, ListDisplacement&);
FURNAS_FOR_EACH_NUMERICS(FURNAS_INSTANTIATE)
#undef FURNAS_INSTANTIATE

}  // namespace furnas
