#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <numbers>

#include "tests/engine/laws/every_law.h"
#include "tests/engine/support/setups.h"

namespace furnas {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double radius = 0.5;  // of the small sphere [d_s]

template <class Law>
class Wedge : public testing::Test {};
TYPED_TEST_SUITE(Wedge, EveryFrictionLaw, LawName);

/// Whether a small sphere between two large ones stays when they are pushed together; its contacts are
/// `half_angle` off the line of the large centres.
template <class Law>
bool holds(double size_ratio, double friction, double half_angle) {
  constexpr double speed = 1e-5;  // of each large sphere, as if nothing could stop it
  constexpr int steps = 4000;
  const double large = radius * size_ratio;
  const double reach = large + radius;
  const double side = 16 * reach;
  const Vec3<double> middle{side / 2, side / 2, side / 2};
  const double apart = reach * std::cos(half_angle);
  const Vec3<double> above{0, reach * std::sin(half_angle), 0};
  Packing start = packing_of(
      cube(side),
      {{.position = middle - Vec3<double>{apart, 0, 0}, .velocity = {speed, 0, 0}, .radius = large},
       {.position = middle + Vec3<double>{apart, 0, 0}, .velocity = {-speed, 0, 0}, .radius = large},
       {.position = middle + above, .radius = radius}});
  start.mass[0] = start.mass[1] = 1e30;
  const Packing end = after(model_of<Law>({.friction = friction}), start, steps);
  const double pushed = speed * end.time;
  return end.position(2).y - start.position(2).y < 0.1 * pushed;
}

template <class Law>
double threshold(double size_ratio, double friction) {
  // Beyond this the large spheres would meet each other.
  const double widest = std::acos(size_ratio / (size_ratio + 1)) - 0.2 * degree;
  double held = 0.5 * std::atan(friction);
  double ejected = std::min(1.5 * std::atan(friction), widest);
  EXPECT_TRUE(holds<Law>(size_ratio, friction, held));
  EXPECT_FALSE(holds<Law>(size_ratio, friction, ejected));
  while (ejected - held > 0.01 * degree) {
    const double between = 0.5 * (held + ejected);
    (holds<Law>(size_ratio, friction, between) ? held : ejected) = between;
  }
  return 0.5 * (held + ejected);
}

// T18: friction mu holds a wedge of half angle beta if tan beta <= mu. The large spheres approach without
// turning, so with k_t = k_n and gamma_t = gamma_n the springs of both directions answer alike, the sphere
// does not move before it slips, and the threshold is sharp.
TYPED_TEST(Wedge, IsHeldUpToTheAngleOfFriction) {
  struct Case {
    double size_ratio, friction;
  };
  for (const auto& [size_ratio, friction] :
       {Case{2, 0.1}, {2, 0.5}, {5, 0.1}, {5, 0.5}, {10, 0.1}, {10, 0.3}, {20, 0.2}, {40, 0.1}, {40, 0.2}}) {
    const double is = threshold<TypeParam>(size_ratio, friction) / degree;
    std::cout << "size ratio " << size_ratio << ", friction " << friction << ": held up to " << is
              << " degrees, atan(mu) " << std::atan(friction) / degree << '\n';
    EXPECT_NEAR(is, std::atan(friction) / degree, 0.1);
  }
}

}  // namespace
}  // namespace furnas
