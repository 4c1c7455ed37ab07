#pragma once

#include <cstddef>

#include "engine/model.h"
#include "engine/state/cell.h"
#include "engine/state/stress.h"

namespace furnas {

/// Half a kick of the cell's strain rate: W e' = V (P - p_a I) + (kinetic trace)/(3 N) I, then its drag.
void kick_cell(const Barostat& barostat, const double& time_step, const std::size_t& particles,
               const Stress& stress, Cell& cell);

/// Half a step of the cell's edges: h' = e h with constant e.
void stretch_cell(const Barostat& barostat, const double& time_step, Cell& cell);

}  // namespace furnas
