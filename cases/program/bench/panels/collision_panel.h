#pragma once

#include <string>
#include <vector>

#include "cases/program/bench/panels/panel.h"

namespace furnas {

/// The error of one quantity after a collision of two small spheres, over all phases of entry and exit.
struct CollisionError {
  std::string law, precision;
  double steps{};        ///< in a collision, t_c/dt
  std::string quantity;  ///< "restitution", "slip stuck", "slip sliding", "spin sliding"
  double expected{};     ///< by the closed form
  double mean{}, rms{};  ///< of (measured - expected)/expected
};

/// Errors in the panel `collision`: restitution exp(-gamma t/2) of a head-on collision; slip with mu = 1e30;
/// slip and spin when the contact slides throughout. The closed forms are in engine/trials/closed_form.h.
std::vector<CollisionError> collision_errors(Effort effort);

/// Table and charts of these results.
PanelResult panel_of(const std::vector<CollisionError>& errors);

}  // namespace furnas
