#include "viz/view.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/base/require.h"

namespace furnas {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double azimuth = 32 * degree;    // from -y towards +x
constexpr double elevation = 26 * degree;  // above the x-y plane
constexpr double half_angle = 7 * degree;  // of the longer side of the frame: weak perspective
constexpr double margin = 0.02;            // of the frame, free on each side

}  // namespace

std::array<double, 2> View::project(const Vec3<double>& point) const {
  const Vec3<double> d = point - eye;
  const double depth = -dot(d, toward);
  return {dot(d, right) / (depth * slope_x), dot(d, up) / (depth * slope_y)};
}

ViewFit::ViewFit(double aspect, double turn) {
  using std::cos, std::sin;
  const double about = azimuth + turn * degree;
  axes_.right = {cos(about), sin(about), 0};
  axes_.toward = {sin(about) * cos(elevation), -cos(about) * cos(elevation), sin(elevation)};
  axes_.up = cross(axes_.toward, axes_.right);
  axes_.slope_x = std::tan(half_angle) * std::min(1.0, aspect);
  axes_.slope_y = axes_.slope_x / aspect;
  std::fill(std::begin(reach_), std::end(reach_), -std::numeric_limits<double>::infinity());
}

void ViewFit::add(const Vec3<double>& centre, double radius) {
  const double x = dot(centre, axes_.right), y = dot(centre, axes_.up), z = dot(centre, axes_.toward);
  const double free = 1 - 2 * margin;
  const double a = std::atan(axes_.slope_x * free), b = std::atan(axes_.slope_y * free);
  const auto grow = [](double& most, double value) { most = std::max(most, value); };
  grow(reach_[0], std::cos(a) * x + std::sin(a) * z + radius);
  grow(reach_[1], -std::cos(a) * x + std::sin(a) * z + radius);
  grow(reach_[2], std::cos(b) * y + std::sin(b) * z + radius);
  grow(reach_[3], -std::cos(b) * y + std::sin(b) * z + radius);
  grow(front_, z + radius);
  back_ = std::min(back_, z - radius);
}

View ViewFit::view() const {
  require(front_ > back_, "a view needs something to look at");
  View view = axes_;
  const double free = 1 - 2 * margin;
  const double a = std::atan(view.slope_x * free), b = std::atan(view.slope_y * free);
  // The left and right planes meet in a line, and so do the top and bottom planes. The eye is placed at the
  // farther of these two lines.
  const double x = (reach_[0] - reach_[1]) / (2 * std::cos(a));
  const double y = (reach_[2] - reach_[3]) / (2 * std::cos(b));
  const double z =
      std::max((reach_[0] + reach_[1]) / (2 * std::sin(a)), (reach_[2] + reach_[3]) / (2 * std::sin(b)));
  view.eye = x * view.right + y * view.up + z * view.toward;
  view.nearest = z - front_;
  view.farthest = z - back_;
  return view;
}

}  // namespace furnas
