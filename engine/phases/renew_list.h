#pragma once

#include <optional>
#include <vector>

#include "engine/phases/integrate.h"
#include "engine/search/carry_over.h"
#include "engine/search/displacement.h"
#include "engine/search/grid.h"
#include "engine/state/inner_list.h"
#include "engine/state/state.h"

namespace furnas {

/// Data needed while a list is built. Radii and grids stay, because their memory is used for the next list.
template <class Real>
struct ListDraft {
  Skin skin;                  ///< of the new list
  std::vector<double> radii;  ///< [d_s]
  std::vector<Grid> grids;
  CarriedContacts<Real> contacts;  ///< of the old list
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

/// Chooses the skin and sorts the particles into bins. The reference positions of the list become those of
/// now, and the cells crossed since the former reference are counted.
template <class Numerics>
void bin_particles(const std::optional<double>& skin, const std::int64_t& step, const Cell& cell,
                   const ListDisplacement& displacement,
                   const std::vector<Particle<typename Numerics::Real, Numerics::spins>>& particles,
                   PairList& pairs, std::vector<Image>& image, ListDraft<typename Numerics::Real>& draft);

/// Takes the contacts off the list.
template <class Real>
void pick_up_contacts(const PairList& pairs, const ContactState<Real>& contact_state, ListDraft<Real>& draft);

/// Lists the pairs, in the memory of the former list.
template <class Real>
void search_pairs(const std::int64_t& step, const Cell& cell, const ListDraft<Real>& draft, PairList& pairs);

/// Puts the contacts on the new list.
template <class Numerics>
void put_down_contacts(const PairList& pairs, ListDraft<typename Numerics::Real>& draft,
                       Rows<typename Numerics::Real, Numerics::spins>& rows,
                       ContactState<typename Numerics::Real>& contact_state, ListDisplacement& displacement);

/// Adds the largest displacements of this step to those of the inner list, and decides whether the inner list
/// must be built again.
void watch_inner_list(const std::int64_t& step, const double& time_step,
                      const SquaredDisplacement& squared_displacement, const Cell& cell,
                      const PairList& pairs, InnerList& inner);

}  // namespace furnas
