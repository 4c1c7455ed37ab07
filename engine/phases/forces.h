#pragma once

#include <vector>

#include "engine/model.h"
#include "engine/state/near_rows.h"
#include "engine/state/state.h"

namespace furnas {

/// Applies the law to each pair of the list that overlaps: one row a pair, the memory carried on, the
/// contacts' part of the stress times the volume, and their work. Pairs that do not overlap get a row of
/// zeros and lose their history. `time_step` 0: forces as they are, without a step that led there.
template <class Scene>
void contact_forces(const Model& model, const double& time_step, const Cell& cell, const PairList& pairs,
                    const std::vector<Particle<typename Scene::Real, Scene::spins>>& particles,
                    const std::vector<Load<typename Scene::Real, Scene::spins>>& loads,
                    Rows<typename Scene::Real, Scene::spins>& rows, Memory<typename Scene::Real>& memory,
                    NearRows& near, Eigen::Matrix3d& stress, ContactWork& work);

}  // namespace furnas
