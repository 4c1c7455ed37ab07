#pragma once

#include <vector>

#include "engine/model.h"
#include "engine/state/inner_list.h"
#include "engine/state/state.h"

namespace furnas {

/// Applies the law to each pair of the list that overlaps. Computes the row of each pair (its force and
/// couple), updates the contact state, and sums the contacts' part of the stress times the volume and their
/// work. Pairs that do not overlap get a row of zeros and lose their history. With `time_step` 0 forces are
/// computed from the present state, without a step before it.
template <class Numerics>
void contact_forces(const Model& model, const double& time_step, const Cell& cell, const PairList& pairs,
                    const std::vector<Particle<typename Numerics::Real, Numerics::spins>>& particles,
                    const std::vector<Load<typename Numerics::Real, Numerics::spins>>& loads,
                    Rows<typename Numerics::Real, Numerics::spins>& rows,
                    ContactState<typename Numerics::Real>& contact_state, InnerList& inner,
                    Eigen::Matrix3d& stress, ContactWork& work);

}  // namespace furnas
