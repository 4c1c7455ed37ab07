#include "viz/visible.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace furnas {
namespace {

/// For each pixel, the distance along its ray to the nearest sphere.
class DepthBuffer {
 public:
  DepthBuffer(const View& view, int width, int height)
      : view_(view),
        width_(width),
        height_(height),
        depth_(std::size_t(width) * std::size_t(height), std::numeric_limits<float>::infinity()) {}

  /// Adds a sphere that hides what lies behind it. Its radius is reduced by one pixel, because pixels may be
  /// sampled anywhere within their area.
  void add(const Sphere& sphere) {
    scan(sphere, -1, [](float& nearest, float depth) {
      nearest = std::min(nearest, depth);
      return false;
    });
  }

  /// Whether the sphere may be visible in any pixel.
  bool sees(const Sphere& sphere) {
    const double slack = 2 * view_.pixel(view_.farthest, height_);
    return scan(sphere, 1, [slack](const float& nearest, float depth) { return depth - slack <= nearest; });
  }

 private:
  /// Calls look(nearest, depth) for each pixel whose ray meets the sphere, whose radius is enlarged by
  /// `pixels`. `depth` is the depth of the meeting point. Stops when `look` returns true.
  template <class Look>
  bool scan(const Sphere& sphere, double pixels, Look&& look) {
    const Vec3<double> d = Vec3<double>{sphere.centre.x, sphere.centre.y, sphere.centre.z} - view_.eye;
    const Vec3<double> c{dot(d, view_.right), dot(d, view_.up), -dot(d, view_.toward)};  // c.z: depth
    const double radius = sphere.radius + pixels * view_.pixel(c.z, height_);
    if (radius <= 0) return false;
    // A sphere off the axis appears slightly larger than its radius divided by its depth.
    const double reach = 1.05 * radius / (c.z - radius);
    const Range columns = range(c.x / c.z / view_.slope_x, reach / view_.slope_x, width_);
    const Range rows = range(c.y / c.z / view_.slope_y, reach / view_.slope_y, height_);
    const double beyond = dot(c, c) - radius * radius;
    for (int row = rows.first; row <= rows.last; ++row) {
      const double y = ((2 * row + 1.0) / height_ - 1) * view_.slope_y;
      for (int column = columns.first; column <= columns.last; ++column) {
        const double x = ((2 * column + 1.0) / width_ - 1) * view_.slope_x;
        const double a = x * x + y * y + 1;
        const double b = x * c.x + y * c.y + c.z;
        const double root = b * b - a * beyond;
        if (root < 0) continue;
        float& nearest = depth_[std::size_t(row) * std::size_t(width_) + std::size_t(column)];
        if (look(nearest, static_cast<float>((b - std::sqrt(root)) / a))) return true;
      }
    }
    return false;
  }

  struct Range {
    int first, last;
  };
  static Range range(double middle, double reach, int pixels) {
    const auto at = [pixels](double x) { return (x + 1) / 2 * pixels - 0.5; };
    return {std::max(0, static_cast<int>(std::floor(at(middle - reach)))),
            std::min(pixels - 1, static_cast<int>(std::ceil(at(middle + reach))))};
  }

  const View& view_;
  int width_, height_;
  std::vector<float> depth_;
};

}  // namespace

std::vector<Sphere> visible(const std::vector<Sphere>& spheres, const View& view, int width, int height) {
  DepthBuffer buffer(view, width, height);
  for (const Sphere& sphere : spheres) buffer.add(sphere);
  std::vector<Sphere> seen;
  std::copy_if(spheres.begin(), spheres.end(), std::back_inserter(seen),
               [&](const Sphere& sphere) { return buffer.sees(sphere); });
  return seen;
}

}  // namespace furnas
