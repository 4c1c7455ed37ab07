#pragma once

#include <numbers>

#include "engine/trials/balls.h"

namespace furnas {

/// A small sphere between two large ones that are pushed together. The line from a large centre to the small
/// one makes an angle of `half_angle` with the line of the large centres. Friction mu holds the small sphere
/// if tan(half_angle) <= mu. The large spheres approach each other without rotation. With k_t = k_n and
/// gamma_t = gamma_n the normal and tangential springs respond alike, so the small sphere does not move
/// before it slips, and the threshold is sharp.
struct WedgedSphere {
  double size_ratio, friction;

  static constexpr double degree = std::numbers::pi / 180;
  static constexpr double radius = 0.5;  ///< of the small sphere [d_s]

  /// atan mu.
  double threshold() const;
  /// 0.2 degrees less than the half angle at which the large spheres touch each other.
  double widest() const;
};

/// Simulates the approach of the large spheres. Returns whether the small sphere stays in place. `model` must
/// have the friction of the wedge and a fixed cell.
bool holds(const WedgedSphere& wedge, const Model& model, double half_angle);

/// The result of the search for the threshold: the largest angle that held and the smallest that did not.
struct WedgeThreshold {
  double held, ejected;
  double middle() const { return 0.5 * (held + ejected); }
};

/// Bisects the interval from half to one and a half times atan mu, or to widest() if this is smaller, until
/// it is 0.01 degrees wide. Throws ContractError if the sphere is not held at the lower end, or is held at
/// the upper end.
WedgeThreshold threshold_of(const WedgedSphere& wedge, const Model& model);

}  // namespace furnas
