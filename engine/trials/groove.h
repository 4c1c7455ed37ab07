#pragma once

#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "engine/trials/balls.h"

namespace furnas {

/// A small sphere in the groove between two large ones that touch and do not move, one degree off the top
/// (`examples/granular/3ps.dat` of LAMMPS; Vyas, Ottino, Lueptow, Umbanhowar, Comput. Phys. Commun. 310
/// (2025) 109524). It rolls down around their point of contact and falls off.
struct Groove {
  double size_ratio;
  double gravity;  ///< [d_s/time^2]
  double friction;

  static constexpr double degree = std::numbers::pi / 180;
  static constexpr double radius = 0.5;       ///< of the small sphere [d_s]
  static constexpr double tilt = 1 * degree;  ///< at the start

  double large() const { return radius * size_ratio; }
  double reach() const { return large() + radius; }
  /// Radius of the ring on which the small sphere's centre moves [d_s].
  double ring() const { return std::sqrt(reach() * reach() - large() * large()); }
  /// tan of half the angle of the wedge that the large spheres form for the small one.
  double wedge() const { return ring() / large(); }
  /// Force of each contact while the small sphere lies on the top [k_n d_s].
  double load() const { return mass_of(radius) * gravity * reach() / (2 * ring()); }

  /// Rolling of a rigid sphere to an angle: (ring^2 + 0.4 reach^2) theta'^2/2 = g ring (cos tilt - cos
  /// theta), because a sphere that touches on both sides of its axis has the short lever arm radius
  /// ring/reach.
  double rolling_time(double angle) const;

  Packing start() const;
};

/// How a small sphere went down a groove.
struct Descent {
  std::vector<double> passed;  ///< when the angles asked for were passed; shorter if some never were [time]
  std::optional<double> escaped;  ///< when it had left both large spheres [time]
  double largest_load{};          ///< largest force of a contact/that on the top
};

/// The descent in steps of `time_step`, for at most three times as long as a rigid sphere rolls to 60
/// degrees. Law: HookeSynchronized or HookeHistory.
template <class Law>
Descent descend(const Groove& groove, double time_step, const std::vector<double>& angles = {});

}  // namespace furnas
