#pragma once

#include <array>
#include <limits>

#include "engine/base/vec3.h"

namespace furnas {

/// A perspective camera.
struct View {
  Vec3<double> right, up, toward;  ///< orthonormal axes; `toward` points from the scene to the eye
  Vec3<double> eye;                ///< [d_s]
  double slope_x{}, slope_y{};     ///< half width and half height of the frame at unit distance
  double nearest{}, farthest{};    ///< depths between which the scene lies, from the eye [d_s]

  /// Position of a point in the frame: (-1, -1) bottom left, (1, 1) top right.
  std::array<double, 2> project(const Vec3<double>& point) const;

  /// Width of one pixel at distance `depth` from the eye, for a frame of `height` pixels [d_s].
  double pixel(double depth, int height) const { return 2 * slope_y * depth / height; }
};

/// Finds the view from a fixed direction whose frame just contains everything that was added.
class ViewFit {
 public:
  /// Three-quarter view from the front, right and above, for a frame of width / height `aspect`. The eye is
  /// rotated further to the right by `turn` degrees about the vertical.
  explicit ViewFit(double aspect, double turn = 0);

  /// Adds a sphere that must lie completely in the frame; lengths in d_s.
  void add(const Vec3<double>& centre, double radius);

  /// At least one sphere of nonzero size must have been added.
  View view() const;

 private:
  /// The directions of the four planes that bound the frame are known. `reach_` is the largest distance of an
  /// added sphere beyond each plane, measured from a parallel plane through the origin.
  double reach_[4];
  double front_ = -std::numeric_limits<double>::infinity();
  double back_ = std::numeric_limits<double>::infinity();
  View axes_;
};

}  // namespace furnas
