#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>

#include "engine/monitor/measure.h"
#include "tests/engine/laws/every_law.h"
#include "tests/engine/support/setups.h"

namespace furnas {
namespace {

const Triangle edges{3, 3.5, 4, 0.6, -0.9, 1.1};
const Triangle rate{0.02, -0.03, 0.01, 0.05, -0.04, 0.06};

/// A cell whose rate nothing can change.
template <class Law>
Model driven(const HookeConstants& constants, double time_step = paper_step) {
  Model model = model_of<Law>(constants, time_step);
  model.barostat = {.pressure = 0, .inertia = 1e300};
  return model;
}

/// A pair that overlaps along an oblique branch, put down so that its first particle lies at `corner` in
/// units of the cell: seen direct, or through faces, edges and corners.
Packing pair_at(const Vec3<double>& corner) {
  const Vec3<double> branch{0.5, 0.55, 0.56};
  Packing p = packing_of(
      edges, {{.velocity = {0.3, -0.2, 0.1}, .radius = 0.7}, {.velocity = {-0.1, 0.25, 0.4}, .radius = 0.5}});
  p.cell.rate = rate;
  p.fraction[0] = to_fraction(corner);
  const Fraction apart = to_fraction(inverse(edges) * branch);
  const Fraction& s = p.fraction[0];
  p.fraction[1] = {s.x - apart.x, s.y - apart.y, s.z - apart.z};
  return p;
}

/// Corners at which the pair stands free (0.5) or reaches across a face (0), in every combination.
std::vector<Vec3<double>> corners() {
  std::vector<Vec3<double>> all;
  for (double x : {0.5, 0.05})
    for (double y : {0.5, 0.05})
      for (double z : {0.5, 0.05}) all.push_back({x, y, z});
  return all;
}

/// A law that only damps: F = overlap n - m_eff gamma v, so a force tells the velocity that the law saw.
constexpr double damping = 0.5;
constexpr HookeConstants damped{
    .tangential_stiffness = 0, .normal_damping = damping, .tangential_damping = damping, .friction = 1e30};

Vec3<double> seen_velocity(const Packing& p, const Contact& c) {
  const Vec3<double> n = c.branch * (1 / norm(c.branch));
  return (c.overlap * n - c.force) * (1 / (damping * reduced_mass_of(p.radius[c.i], p.radius[c.j])));
}

template <class Law>
class MovingCell : public testing::Test {};
TYPED_TEST_SUITE(MovingCell, EveryFrictionLaw, LawName);

// T41: the law sees v_i - v_j of the peculiar velocities, or with `affine_velocity` that of the total ones,
// v + e x. An image k cells away moves with its particle and with the cell's own motion h' k. The overlap is
// known to 1e-16 of the lengths, so velocities to 1e-15/(gamma m_eff) = 1e-14.
TYPED_TEST(MovingCell, APairHasOneRelativeVelocityWhereverItIsSeen) {
  for (bool affine : {false, true}) {
    Model model = driven<TypeParam>(damped);
    model.affine_velocity = affine;
    int through = 0;
    for (const Vec3<double>& corner : corners()) {
      const Packing p = after(model, pair_at(corner), 0);
      ASSERT_EQ(p.contacts.size(), 1u);
      const Contact& c = p.contacts.front();
      const Vec3<double> x_i = p.position(c.i);
      const Vec3<double> x_j = p.position(c.j);
      const Vec3<double> shift = inverse(edges) * (x_i - x_j - c.branch);  // cells, of the image of j
      const Vec3<double> k{std::nearbyint(shift.x), std::nearbyint(shift.y), std::nearbyint(shift.z)};
      ASSERT_LT(norm(shift - k), 1e-14);
      through += k != Vec3<double>{};
      Vec3<double> expected = p.velocity[c.i] - p.velocity[c.j];
      if (affine) expected += rate * x_i - (rate * x_j + product(rate, edges) * k);
      EXPECT_LT(norm(seen_velocity(p, c) - expected), 1e-13) << corner.x << corner.y << corner.z;
    }
    EXPECT_EQ(through, 7);
  }
}

// T41: and so the motion of the pair has the same bits wherever it takes place, while the cell moves on.
TYPED_TEST(MovingCell, APairMovesAlikeAcrossEachFace) {
  for (bool affine : {false, true}) {
    Model model = driven<TypeParam>({.friction = 0.5});
    model.affine_velocity = affine;
    const Packing direct = after(model, pair_at({0.5, 0.5, 0.5}), 60);
    for (const Vec3<double>& corner : corners()) {
      const Packing p = after(model, pair_at(corner), 60);
      EXPECT_EQ(p.velocity, direct.velocity);
      EXPECT_EQ(p.spin, direct.spin);
      EXPECT_EQ(p.force, direct.force);
    }
  }
}

// T41: what the cell does is no motion of the particles: spheres at rest have no kinetic energy and no
// kinetic stress, stay at rest, and are carried to exp(e t) x.
TYPED_TEST(MovingCell, CarriesSpheresAtRest) {
  const Packing start = [] {
    Packing p = packing_of(edges, {{.position = {0.2, 0.3, 0.4}}, {.position = {1.9, 2.2, 2.5}}});
    p.cell.rate = rate;
    return p;
  }();
  constexpr int steps = 300;
  Packing p = after(driven<TypeParam>({.friction = 0.5}), start, steps);
  ASSERT_TRUE(p.contacts.empty());
  EXPECT_EQ(measure(p, 3).kinetic_energy, 0);
  EXPECT_EQ(p.stress.motion, Eigen::Matrix3d::Zero());
  EXPECT_EQ(p.velocity, start.velocity);
  EXPECT_EQ(p.fraction, start.fraction);
  // exp(e t) x by its series; 30 terms of a number near 1.
  const double time = steps * paper_step;
  for (std::size_t k = 0; k < p.size(); ++k) {
    Vec3<double> term = start.position(k);
    Vec3<double> sum = term;
    for (int n = 1; n <= 30; ++n) {
      term = (time / n) * (rate * term);
      sum += term;
    }
    EXPECT_LT(norm(p.position(k) - sum), 1e-12);
  }
}

using Orbit = Eigen::Matrix<double, 6, 1>;  // position, then velocity

/// x' = v + e x, v' = -(e + tr(e)/(3 N)) v after a time, by the series of the exponential: 80 terms of a
/// number below 10.
Orbit free_motion(const Vec3<double>& x, const Vec3<double>& v, const Triangle& e, int particles,
                  double time) {
  Eigen::Matrix3d shear;
  shear << e.xx, e.xy, e.xz, 0, e.yy, e.yz, 0, 0, e.zz;
  Eigen::Matrix<double, 6, 6> slope = Eigen::Matrix<double, 6, 6>::Zero();
  slope.topLeftCorner<3, 3>() = shear;
  slope.topRightCorner<3, 3>().setIdentity();
  slope.bottomRightCorner<3, 3>() = -shear - e.trace() / (3 * particles) * Eigen::Matrix3d::Identity();
  Orbit term;
  term << x.x, x.y, x.z, v.x, v.y, v.z;
  Orbit sum = term;
  for (int n = 1; n <= 80; ++n) {
    term = (time / n) * (slope * term).eval();
    sum += term;
  }
  return sum;
}

// A free particle in a cell that deforms steadily: the velocity, which this splitting does exactly but for
// the order of stretch and shear, and the position are of second order in the step.
TEST(MovingCell, FreeFlightIsOfSecondOrder) {
  const Vec3<double> x{1, 2, 3};
  const Vec3<double> v{0.05, -0.03, 0.08};
  const Triangle strong{0.2, -0.1, -0.15, 0.3, -0.25, 0.4};
  Packing start =
      packing_of({12, 13, 14, 1, -2, 3}, {{.position = x, .velocity = v}, {.position = {7, 8, 9}}});
  start.cell.rate = strong;
  constexpr int steps = 128;
  constexpr double long_step = 1.0 / 64;
  const Orbit exact = free_motion(x, v, strong, 2, steps * long_step);
  const auto error = [&](int divisions) {
    const Packing p = after(driven<Frictionless<false>>({}, long_step / divisions), start, steps * divisions);
    const Vec3<double> now = p.unwrapped(0);
    Orbit is;
    is << now.x, now.y, now.z, p.velocity[0].x, p.velocity[0].y, p.velocity[0].z;
    return std::pair{(is - exact).head<3>().norm(), (is - exact).tail<3>().norm()};
  };
  const auto [place, velocity] = error(1);
  const auto [half_place, half_velocity] = error(2);
  EXPECT_LT(place, 1e-4);
  EXPECT_LT(velocity, 1e-5);
  EXPECT_NEAR(std::log2(place / half_place), 2, 0.1);
  EXPECT_NEAR(std::log2(velocity / half_velocity), 2, 0.1);
}

}  // namespace
}  // namespace furnas
