#pragma once

#include <optional>
#include <vector>

#include "engine/phases/integrate.h"
#include "engine/search/grid.h"
#include "engine/search/wear.h"
#include "engine/state/near_rows.h"
#include "engine/state/state.h"

namespace furnas {

/// What building a list needs.
struct ListDraft {
  std::vector<double> radii;  ///< [d_s]
  std::vector<Grid> grids;
  PairList fresh;  ///< its reference: the positions
};

/// Adds the longest ways of this step to the wear and says whether it must be measured.
void watch_wear(const std::int64_t& step, const LongestWay& longest_way, const Cell& cell,
                const PairList& pairs, Wear& wear);

/// Measures how far particles have really moved since the list was built.
template <class Scene>
void measure_wear(const std::optional<double>& skin, const std::int64_t& step, const Cell& cell,
                  const PairList& pairs,
                  const std::vector<Particle<typename Scene::Real, Scene::spins>>& particles, Wear& wear);

/// Chooses the skin and sorts the particles into bins.
template <class Scene>
void bin_particles(const std::optional<double>& skin, const std::int64_t& step, const Cell& cell,
                   const Wear& wear, const PairList& pairs,
                   const std::vector<Particle<typename Scene::Real, Scene::spins>>& particles,
                   ListDraft& draft);

/// Lists the pairs.
void search_pairs(const Cell& cell, ListDraft& draft);

/// Puts the new list in the place of the old one; the memory and the count of crossed cells survive.
template <class Scene>
void adopt_list(const std::int64_t& step, ListDraft& draft, PairList& pairs,
                Rows<typename Scene::Real, Scene::spins>& rows, Memory<typename Scene::Real>& memory,
                std::vector<Image>& image, Wear& wear);

/// Adds the longest ways of this step to those of the near rows, and says whether they must be noted anew.
void watch_near_rows(const std::int64_t& step, const double& time_step, const LongestWay& longest_way,
                     const Cell& cell, const PairList& pairs, NearRows& near);

}  // namespace furnas
