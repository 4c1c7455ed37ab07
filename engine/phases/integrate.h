#pragma once

#include <vector>

#include "engine/model.h"
#include "engine/state/state.h"

namespace furnas {

/// Largest displacement of a particle of each size class in this step, without the cell's affine part,
/// measured in the cell as it was when the list was built; squared [d_s^2].
using SquaredDisplacement = std::vector<double>;

/// First half of the step for the particles: effect of the cell's rate on peculiar velocities, half a kick,
/// drift.
template <class Numerics>
void kick_and_drift(const Barostat& bath, const double& time_step, const Cell& cell, const PairList& pairs,
                    const ContactState<typename Numerics::Real>& contact_state,
                    const std::vector<Load<typename Numerics::Real, Numerics::spins>>& loads,
                    std::vector<Particle<typename Numerics::Real, Numerics::spins>>& particles,
                    SquaredDisplacement& squared_displacement);

/// Second half of the step: the sum over the contacts of each particle, in an order that does not depend on
/// the threads, then half a kick and the effect of the cell's rate. `motion` becomes the kinetic part of the
/// stress times the volume. With `time_step` 0 only the sums are computed.
template <class Numerics>
void gather_and_kick(const Barostat& bath, const double& time_step, const Cell& cell, const PairList& pairs,
                     const Rows<typename Numerics::Real, Numerics::spins>& rows,
                     ContactState<typename Numerics::Real>& contact_state,
                     std::vector<Load<typename Numerics::Real, Numerics::spins>>& loads,
                     std::vector<Particle<typename Numerics::Real, Numerics::spins>>& particles,
                     Eigen::Matrix3d& motion);

}  // namespace furnas
