#pragma once

#include <numbers>

#include "engine/trials/balls.h"

namespace furnas {

/// A small sphere between two large ones that are pushed together; its contacts are `half_angle` off the line
/// of the large centres. Friction mu holds it if tan(half_angle) <= mu: the large spheres approach without
/// turning, so with k_t = k_n and gamma_t = gamma_n the springs of both directions answer alike, the sphere
/// does not move before it slips, and the threshold is sharp.
struct WedgedSphere {
  double size_ratio, friction;

  static constexpr double degree = std::numbers::pi / 180;
  static constexpr double radius = 0.5;  ///< of the small sphere [d_s]

  /// atan mu.
  double threshold() const;
  /// Beyond this the large spheres would meet each other.
  double widest() const;
};

/// Whether the small sphere stays. `model` has the friction of the wedge and a cell that does not move.
bool holds(const WedgedSphere& wedge, const Model& model, double half_angle);

/// What held and what did not when the threshold of a law was looked for.
struct WedgeThreshold {
  double held, ejected;
  double middle() const { return 0.5 * (held + ejected); }
};

/// Halves the angles from half to one and a half times atan mu until they are 0.01 degrees apart. Throws
/// ContractError when the first is not held or the last is.
WedgeThreshold threshold_of(const WedgedSphere& wedge, const Model& model);

}  // namespace furnas
