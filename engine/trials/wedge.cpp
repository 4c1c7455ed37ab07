#include "engine/trials/wedge.h"

#include <algorithm>
#include <cmath>

#include "engine/base/require.h"

namespace furnas {

double WedgedSphere::threshold() const { return std::atan(friction); }

double WedgedSphere::widest() const { return std::acos(size_ratio / (size_ratio + 1)) - 0.2 * degree; }

bool holds(const WedgedSphere& wedge, const Model& model, double half_angle) {
  constexpr double speed = 1e-5;  // of each large sphere; its mass of 1e30 keeps the speed constant
  const double time = 4000 * paper_step;
  const double large = WedgedSphere::radius * wedge.size_ratio;
  const double reach = large + WedgedSphere::radius;
  const double side = 16 * reach;
  const Vec3<double> middle{side / 2, side / 2, side / 2};
  const double apart = reach * std::cos(half_angle);
  const Vec3<double> above{0, reach * std::sin(half_angle), 0};
  Packing start = packing_of(
      cube(side),
      {{.position = middle - Vec3<double>{apart, 0, 0}, .velocity = {speed, 0, 0}, .radius = large},
       {.position = middle + Vec3<double>{apart, 0, 0}, .velocity = {-speed, 0, 0}, .radius = large},
       {.position = middle + above, .radius = WedgedSphere::radius}});
  start.mass[0] = start.mass[1] = 1e30;
  const Packing end = after(model, start, std::lround(time / model.time_step));
  const double pushed = speed * end.time;
  return end.position(2).y - start.position(2).y < 0.1 * pushed;
}

WedgeThreshold threshold_of(const WedgedSphere& wedge, const Model& model) {
  WedgeThreshold t{0.5 * wedge.threshold(), std::min(1.5 * wedge.threshold(), wedge.widest())};
  require(holds(wedge, model, t.held) && !holds(wedge, model, t.ejected),
          "the threshold lies between the angles");
  while (t.ejected - t.held > 0.01 * WedgedSphere::degree) {
    const double between = t.middle();
    (holds(wedge, model, between) ? t.held : t.ejected) = between;
  }
  return t;
}

}  // namespace furnas
