#pragma once

#include <vector>

#include "engine/model.h"
#include "engine/state/state.h"

namespace furnas {

/// Longest way of a particle of each size class in this step, the affine part apart, measured in the cell
/// as it was when the list was built; squared [d_s^2].
using LongestWay = std::vector<double>;

/// First half of the step for the particles: cell's drag on peculiar velocities, half a kick, drift.
template <class Scene>
void kick_and_drift(const Barostat& bath, const double& time_step, const Cell& cell, const PairList& pairs,
                    const Memory<typename Scene::Real>& memory,
                    const std::vector<Load<typename Scene::Real, Scene::spins>>& loads,
                    std::vector<Particle<typename Scene::Real, Scene::spins>>& particles,
                    LongestWay& longest_way);

/// Second half: the sum over the contacts of each particle, in an order that no thread changes, then
/// half a kick and the cell's drag. `motion` becomes the kinetic part of the stress, times the volume.
/// With `time_step` 0 only the sums are taken.
template <class Scene>
void gather_and_kick(const Barostat& bath, const double& time_step, const Cell& cell, const PairList& pairs,
                     const Rows<typename Scene::Real, Scene::spins>& rows,
                     Memory<typename Scene::Real>& memory,
                     std::vector<Load<typename Scene::Real, Scene::spins>>& loads,
                     std::vector<Particle<typename Scene::Real, Scene::spins>>& particles,
                     Eigen::Matrix3d& motion);

}  // namespace furnas
