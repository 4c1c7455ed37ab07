#pragma once

#include "engine/graph/step_graph.h"
#include "engine/model.h"
#include "engine/phases/renew_list.h"
#include "engine/state/state.h"

namespace furnas {

/// What the phases pass to each other within a step.
template <class Real>
struct StepWork {
  SquaredDisplacement squared_displacement;
  ListDisplacement displacement;
  InnerList inner;
  /// Between steps only memory kept for the next list, so a function that leaves the state as it is may
  /// release it.
  mutable ListDraft<Real> draft;
  ContactWork work;
};

/// The timestep: velocity Verlet for particles and cell, one line of code per phase. The order of the lines
/// alone determines the order of the phases. The arguments must outlive the graph and must not move in
/// memory.
template <class Numerics>
StepGraph make_step(const Model& model, const std::size_t& particles, State<Numerics>& state,
                    StepWork<typename Numerics::Real>& work);

}  // namespace furnas
