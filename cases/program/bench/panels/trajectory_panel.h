#pragma once

#include <string>
#include <vector>

#include "cases/program/bench/panels/panel.h"

namespace furnas {

/// How long two ways to compute a trajectory stay close to each other.
struct TrajectoryError {
  std::string precision;
  int threads{};
  double step{};        ///< [t_c]
  std::string against;  ///< "a short step": an eighth of the shortest step shown, double; or "1 thread"
  double parted{};  ///< time when a position first differed by 1e-3 d_s, or the length of the run if none did
                    ///< [t_c]
  bool ever{};      ///< whether a position differed by so much
  double largest{};  ///< largest distance between the two positions of a particle at the end [d_s]
};

/// Errors in the panel `trajectory`: a gas of frictional spheres without damping, in which errors grow and
/// the motion does not die out.
std::vector<TrajectoryError> trajectory_errors(Effort effort);

/// Table and charts of these results.
PanelResult panel_of(const std::vector<TrajectoryError>& errors);

}  // namespace furnas
