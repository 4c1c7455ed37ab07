#include "engine/phases/renew_list.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/base/parallel.h"
#include "engine/base/refill.h"
#include "engine/search/find_pairs.h"
#include "engine/search/inner_skin.h"

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
                   const ListDisplacement& displacement,
                   const std::vector<Particle<typename Numerics::Real, Numerics::spins>>& particles,
                   PairList& pairs, std::vector<Image>& image, ListDraft<typename Numerics::Real>& draft) {
  const bool first = pairs.reference.empty();
  pairs.reference.resize(particles.size());
  draft.radii.resize(particles.size());
  for_chunks(particles.size(), 1024, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t i = begin; i < end; ++i) {
      if (!first) image[i] = crossed(image[i], pairs.reference[i], particles[i].position);
      pairs.reference[i] = particles[i].position;
      draft.radii[i] = particles[i].radius;
    }
  });
  draft.skin = next_skin(pairs, displacement.largest,
                         pairs.builds > 0 ? shrinkage(pairs.edges, cell.edges) : 0, step, skin);
  draft.grids = bin_classes(pairs.classes, draft.skin, cell.edges, pairs.reference, std::move(draft.grids));
}

template <class Real>
void pick_up_contacts(const PairList& pairs, const ContactState<Real>& contact_state,
                      ListDraft<Real>& draft) {
  draft.contacts = contacts_of_rows(pairs, contact_state, pairs.reference);
}

template <class Real>
void search_pairs(const std::int64_t& step, const Cell& cell, const ListDraft<Real>& draft, PairList& pairs) {
  pairs.skin = draft.skin;
  pairs.step = step;
  ++pairs.builds;
  find_pairs(draft.grids, cell.edges, draft.radii, pairs);
}

template <class Numerics>
void put_down_contacts(const PairList& pairs, ListDraft<typename Numerics::Real>& draft,
                       Rows<typename Numerics::Real, Numerics::spins>& rows,
                       ContactState<typename Numerics::Real>& contact_state, ListDisplacement& displacement) {
  enter_contacts(draft.contacts, pairs, pairs.reference, Numerics::spins, contact_state);
  draft.contacts = {};
  refill(rows, pairs.rows(), {});
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

#define FURNAS_INSTANTIATE(Law, Real)                                                                    \
  template void measure_displacement<Numerics<Law, Real>>(                                               \
      const std::optional<double>&, const std::int64_t&, const Cell&, const PairList&,                   \
      const std::vector<Particle<Real, Law::spins>>&, ListDisplacement&);                                \
  template void bin_particles<Numerics<Law, Real>>(                                                      \
      const std::optional<double>&, const std::int64_t&, const Cell&, const ListDisplacement&,           \
      const std::vector<Particle<Real, Law::spins>>&, PairList&, std::vector<Image>&, ListDraft<Real>&); \
  template void put_down_contacts<Numerics<Law, Real>>(                                                  \
      const PairList&, ListDraft<Real>&, Rows<Real, Law::spins>&, ContactState<Real>&, ListDisplacement&);
FURNAS_FOR_EACH_NUMERICS(FURNAS_INSTANTIATE)
#undef FURNAS_INSTANTIATE

#define FURNAS_INSTANTIATE(Real)                                                                \
  template void pick_up_contacts(const PairList&, const ContactState<Real>&, ListDraft<Real>&); \
  template void search_pairs(const std::int64_t&, const Cell&, const ListDraft<Real>&, PairList&);
FURNAS_INSTANTIATE(double)
FURNAS_INSTANTIATE(float)
#undef FURNAS_INSTANTIATE

}  // namespace furnas
