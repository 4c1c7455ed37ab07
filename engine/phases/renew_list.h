#pragma once

#include <optional>
#include <vector>

#include "engine/phases/integrate.h"
#include "engine/search/displacement.h"
#include "engine/search/grid.h"
#include "engine/state/inner_list.h"
#include "engine/state/state.h"

namespace furnas {

/// Data needed while a list is built.
struct ListDraft {
  std::vector<double> radii;  ///< [d_s]
  std::vector<Grid> grids;
  PairList fresh;  ///< the new list; its `reference` has the positions
};

/// Adds the largest displacements of this step to those since the build, and decides whether the real
/// displacements must be measured.
void add_displacement(const std::int64_t& step, const SquaredDisplacement& squared_displacement,
                      const Cell& cell, const PairList& pairs, ListDisplacement& displacement);

/// Measures the real displacements since the list was built.
template <class Numerics>
void measure_displacement(const std::optional<double>& skin, const std::int64_t& step, const Cell& cell,
                          const PairList& pairs,
                          const std::vector<Particle<typename Numerics::Real, Numerics::spins>>& particles,
                          ListDisplacement& displacement);

/// Chooses the skin and sorts the particles into bins.
template <class Numerics>
void bin_particles(const std::optional<double>& skin, const std::int64_t& step, const Cell& cell,
                   const ListDisplacement& displacement, const PairList& pairs,
                   const std::vector<Particle<typename Numerics::Real, Numerics::spins>>& particles,
                   ListDraft& draft);

/// Lists the pairs.
void search_pairs(const Cell& cell, ListDraft& draft);

/// Replaces the old list by the new one; keeps the contact state and the count of crossed cells.
template <class Numerics>
void adopt_list(const std::int64_t& step, ListDraft& draft, PairList& pairs,
                Rows<typename Numerics::Real, Numerics::spins>& rows,
                ContactState<typename Numerics::Real>& contact_state, std::vector<Image>& image,
                ListDisplacement& displacement);

/// Adds the largest displacements of this step to those of the inner list, and decides whether the inner list
/// must be built again.
void watch_inner_list(const std::int64_t& step, const double& time_step,
                      const SquaredDisplacement& squared_displacement, const Cell& cell,
                      const PairList& pairs, InnerList& inner);

}  // namespace furnas
