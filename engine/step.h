#pragma once

#include "engine/graph/step_graph.h"
#include "engine/model.h"
#include "engine/phases/renew_list.h"
#include "engine/state/state.h"

namespace furnas {

/// What the phases hand to each other within a step.
struct StepWork {
  LongestWay longest_way;
  Wear wear;
  NearRows near;
  ListDraft draft;
  ContactWork work;
};

/// The timestep: velocity Verlet for particles and cell, one line a phase. Nothing else decides the order.
/// The arguments must outlive the graph and stay where they are.
template <class Scene>
StepGraph make_step(const Model& model, const std::size_t& particles, State<Scene>& state, StepWork& work);

}  // namespace furnas
