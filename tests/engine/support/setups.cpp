#include "tests/engine/support/setups.h"

#include <algorithm>
#include <cmath>

#include "engine/base/sphere.h"
#include "engine/start/mixture.h"
#include "tests/engine/support/symmetries.h"

namespace furnas {

Vec3<double> angular_momentum(const Packing& p) {
  Vec3<double> sum;
  for (std::size_t k = 0; k < p.size(); ++k)
    sum +=
        p.mass[k] * cross(p.unwrapped(k), p.velocity[k]) + sphere_inertia(p.mass[k], p.radius[k]) * p.spin[k];
  return sum;
}

double largest_difference(const std::vector<Vec3<double>>& a, const std::vector<Vec3<double>>& b) {
  double largest = a.size() == b.size() ? 0 : INFINITY;
  for (std::size_t k = 0; k < std::min(a.size(), b.size()); ++k)
    largest = std::max(largest, norm(a[k] - b[k]));
  return largest;
}

double sum_of_forces(const Packing& p) {
  double sum = 0;
  for (const Contact& c : p.contacts) sum += norm(c.force);
  return sum;
}

Packing reskewed(const Packing& packing, int xy, int xz, int yz) {
  Packing p = packing;
  p.cell.edges = product(packing.cell.edges, {1, 1, 1, double(yz), double(xz), double(xy)});
  test::number_places_by(p, Eigen::Matrix3i{{1, xy, xz}, {0, 1, yz}, {0, 0, 1}});
  return p;
}

std::vector<Ball> cluster() {
  std::vector<Ball> balls;
  for (int k = 0; k < 9; ++k) {
    const double s = k;
    balls.push_back({.position = 1.1 * Vec3<double>{std::sin(3 * s), std::sin(4 * s), std::cos(5 * s)},
                     .velocity = 0.3 * Vec3<double>{std::sin(7 * s), std::cos(2 * s), std::cos(s)},
                     .spin = {std::cos(s), std::cos(6 * s), std::sin(2 * s)},
                     .radius = k < 2 ? 1.5 : 0.5});
  }
  return balls;
}

Packing alone(std::vector<Ball> balls, double side) {
  for (Ball& ball : balls) ball.position += {side / 2, side / 2, side / 2};
  return packing_of(cube(side), balls);
}

Model jammed_model() { return model_of<HookeSynchronized>({.friction = 0.3}); }

const Packing& jammed() {
  static const Packing packing = [] {
    const Packing gas = dilute_start({.size_ratio = 3, .small_fraction = 0.6, .large = 5, .seed = 7});
    Model model = jammed_model();
    model.barostat.freedom = CellFreedom::triclinic;
    model.barostat.inertia = inertia_of_cell(gas);
    model.barostat.drag = 0.04;
    constexpr int steps = 30000;
    Packing settled = after(model, gas, steps);
    settled.cell.rate = {};
    return settled;
  }();
  return packing;
}

Packing squeezed(double speed) {
  Packing p = jammed();
  constexpr double s = 0.95;
  p.cell.edges = product({s, s, s, 0, 0, 0}, p.cell.edges);
  for (std::size_t k = 0; k < p.size(); ++k) {
    const auto n = static_cast<double>(k);
    p.velocity[k] = speed * Vec3<double>{std::sin(n), std::sin(2 * n), std::cos(3 * n)};
  }
  return p;
}

}  // namespace furnas
