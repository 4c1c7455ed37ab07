#pragma once

#include "engine/graph/step_graph.h"
#include "engine/model.h"
#include "engine/phases/renew_list.h"
#include "engine/state/state.h"

namespace furnas {

/// What the phases pass to each other within a step.
struct StepWork {
  SquaredDisplacement squared_displacement;
  ListDisplacement displacement;
  InnerList inner;
  ListDraft draft;
  ContactWork work;
};

/// The timestep: velocity Verlet for particles and cell, one line of code per phase. The order of the lines
/// alone determines the order of the phases. The arguments must outlive the graph and must not move in
/// memory.
template <class Numerics>
StepGraph make_step(const Model& model, const std::size_t& particles, State<Numerics>& state, StepWork& work);

}  // namespace furnas
