#include "engine/trials/groove.h"

#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>

#include "engine/trials/driven.h"

namespace furnas {

double Groove::rolling_time(double angle) const {
  const double pull =
      gravity * ring() / (ring() * ring() + 0.4 * reach() * reach());  // theta'' = pull sin theta
  // With theta = tilt + x^2 the integrand is regular at the start, where the speed vanishes: cos tilt - cos
  // theta = 2 sin(x^2/2) sin(tilt + x^2/2).
  const auto time_by_root = [&](double x) {
    return x / std::sqrt(pull * std::sin(x * x / 2) * std::sin(tilt + x * x / 2));
  };
  return boost::math::quadrature::gauss_kronrod<double, 61>::integrate(time_by_root, 0.0,
                                                                       std::sqrt(angle - tilt));
}

Packing Groove::start() const {
  const double side = 16 * reach();
  const Vec3<double> top{side / 2, side / 2, side / 2};
  // The contacts carry the weight from the start, so that the sphere does not bounce.
  const double close = reach() - load();
  const double height = std::sqrt(close * close - large() * large());
  Packing p = packing_of(
      cube(side),
      {{.position = top - Vec3<double>{large(), 0, 0}, .radius = large()},
       {.position = top + Vec3<double>{large(), 0, 0}, .radius = large()},
       {.position = top + height * Vec3<double>{0, std::sin(tilt), std::cos(tilt)}, .radius = radius}});
  p.mass[0] = p.mass[1] = 1e30;
  return p;
}

template <class Law>
Descent descend(const Groove& groove, double time_step, const std::vector<double>& angles) {
  const double weight = mass_of(Groove::radius) * groove.gravity;
  const Packing start = groove.start();
  const double middle = start.cell.edges.xx / 2;
  Driven<Law> run(model_of<Law>({.friction = groove.friction}, time_step), start,
                  [&](std::size_t k, const Vec3<double>&, double) {
                    return Vec3<double>{0, 0, k == 2 ? -weight : 0};
                  });
  const double end = 3 * groove.rolling_time(60 * Groove::degree);
  Descent descent;
  double before = Groove::tilt;
  while (run.time() < end && !descent.escaped) {
    run.advance(1);
    const Vec3<double> place = run.position(2);
    const double angle = std::atan2(place.y - middle, place.z - middle);
    const double left = norm(run.force(2, 0));
    const double right = norm(run.force(2, 1));
    descent.largest_load = std::max(descent.largest_load, std::max(left, right) / groove.load());
    while (descent.passed.size() < angles.size() && angle >= angles[descent.passed.size()])
      descent.passed.push_back(run.time() -
                               time_step * (angle - angles[descent.passed.size()]) / (angle - before));
    if (left + right == 0 && angle > 45 * Groove::degree) descent.escaped = run.time();
    before = angle;
  }
  return descent;
}

template Descent descend<HookeSynchronized>(const Groove&, double, const std::vector<double>&);
template Descent descend<HookeHistory>(const Groove&, double, const std::vector<double>&);

}  // namespace furnas
