#pragma once

#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "engine/trials/balls.h"

namespace furnas {

/// A small sphere in the groove between two large spheres that touch and do not move. It starts one degree
/// off the top (`examples/granular/3ps.dat` of LAMMPS; Vyas, Ottino, Lueptow, Umbanhowar, Comput. Phys.
/// Commun. 310 (2025) 109524). The small sphere rolls down around the contact point of the large ones and
/// falls off.
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
  /// tan of half the angle of the wedge that the large spheres form at the small one.
  double wedge() const { return ring() / large(); }
  /// Normal force of each contact while the small sphere rests on the top [k_n d_s].
  double load() const { return mass_of(radius) * gravity * reach() / (2 * ring()); }

  /// Time in which a rigid sphere rolls to an angle, from (ring^2 + 0.4 reach^2) theta'^2/2 = g ring (cos
  /// tilt - cos theta). The factor of 0.4 is reach^2 because the sphere touches on both sides of its axis,
  /// with the short lever arm radius ring/reach.
  double rolling_time(double angle) const;

  Packing start() const;
};

/// The motion of a small sphere down a groove.
struct Descent {
  std::vector<double> passed;     ///< times of passing the angles; shorter if some were never passed [time]
  std::optional<double> escaped;  ///< time at which it had left both large spheres [time]
  double largest_load{};          ///< largest force of a contact/load()
};

/// Simulates the descent in steps of `time_step`, at most three times as long as a rigid sphere takes to roll
/// to 60 degrees. Law: HookeSynchronized or HookeHistory.
template <class Law>
Descent descend(const Groove& groove, double time_step, const std::vector<double>& angles = {});

}  // namespace furnas
