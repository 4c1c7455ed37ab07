#pragma once

#include <string>
#include <vector>

#include "cases/program/bench/panels/panel.h"

namespace furnas {

/// How long one way to compute a trajectory stays with another.
struct TrajectoryError {
  std::string precision;
  int threads{};
  double step{};        ///< [t_c]
  std::string against;  ///< "a short step": an eighth of the shortest step shown, double; or "1 thread"
  double parted{};      ///< when a position was first 1e-3 d_s away; the time followed if none was [t_c]
  bool ever{};          ///< whether one was
  double largest{};     ///< largest distance of a particle from its twin at the end [d_s]
};

/// E6: a gas of spheres with friction that collide without damping, so that errors grow and nothing dies out.
std::vector<TrajectoryError> trajectory_errors(Effort effort);

PanelResult panel_of(const std::vector<TrajectoryError>& errors);

}  // namespace furnas
