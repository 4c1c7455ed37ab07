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
  double nearest{}, farthest{};    ///< distances from the eye, along the axis, that hold the scene [d_s]

  /// Where a point is seen, in the frame: (-1, -1) bottom left, (1, 1) top right.
  std::array<double, 2> project(const Vec3<double>& point) const;

  /// What a frame `height` pixels high shows in one pixel, at distance `depth` from the eye [d_s].
  double pixel(double depth, int height) const { return 2 * slope_y * depth / height; }
};

/// Finds the view from a fixed direction that just holds everything added.
class ViewFit {
 public:
  /// Three-quarter view from the front, right and above for a frame of width / height `aspect`, the eye moved
  /// on to the right by `turn` degrees about the vertical.
  explicit ViewFit(double aspect, double turn = 0);

  /// A sphere that must be seen whole; lengths in d_s.
  void add(const Vec3<double>& centre, double radius);

  /// At least one sphere of nonzero size must have been added.
  View view() const;

 private:
  /// The planes of the frame are known but for their distance: the largest reach of a sphere beyond
  /// each, were the plane through the origin.
  double reach_[4];
  double front_ = -std::numeric_limits<double>::infinity();
  double back_ = std::numeric_limits<double>::infinity();
  View axes_;
};

}  // namespace furnas
