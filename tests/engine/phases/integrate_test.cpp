#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/engine/laws/every_law.h"
#include "tests/engine/support/setups.h"

namespace furnas {
namespace {

template <class Law>
class Motion : public testing::Test {};
TYPED_TEST_SUITE(Motion, EveryLaw, LawName);

// T1: free flight: x = x_0 + v n dt; velocity and spin keep their bits. Each step is rounded alike, so the
// error is far below n eps L.
TYPED_TEST(Motion, WithoutContactIsStraightAndUniform) {
  constexpr double length = 64;
  constexpr int steps = 100000;
  const std::vector<Ball> balls{
      {.position = {5, 6, 7}, .velocity = {0.013, -0.027, 0.0041}, .spin = {0.1, 0.2, -0.3}},
      {.position = {40, 41, 42}, .velocity = {0.013, -0.027, 0.0042}, .spin = {-0.1, 0, 0.7}, .radius = 3}};
  const Packing start = packing_of(cube(length), balls);
  const Packing end = after(model_of<TypeParam>({.friction = 0.3}), start, steps);
  EXPECT_EQ(end.velocity, start.velocity);
  EXPECT_EQ(end.spin, TypeParam::spins ? start.spin : std::vector<Vec3<double>>(2));
  for (std::size_t k = 0; k < 2; ++k) {
    const Vec3<double> expected = start.unwrapped(k) + (steps * paper_step) * start.velocity[k];
    EXPECT_LT(norm(end.unwrapped(k) - expected), 1e-12) << k;
  }
}

// T21: forces are equal and opposite: their sum vanishes and the momentum stays.
TYPED_TEST(Motion, ConservesMomentum) {
  constexpr int steps = TypeParam::synchronized && TypeParam::spins ? 100000 : 20000;
  const Packing start = squeezed(1e-3);
  const Packing end = after(model_of<TypeParam>({.friction = 0.3}), start, steps);
  Vec3<double> force;
  for (const Vec3<double>& f : end.force) force += f;
  ASSERT_GT(end.contacts.size(), 100u);
  EXPECT_LT(norm(force), 1e-12 * sum_of_forces(end));
  double sum = 0;
  for (std::size_t k = 0; k < start.size(); ++k) sum += start.mass[k] * norm(start.velocity[k]);
  EXPECT_LT(norm(momentum(end) - momentum(start)), 1e-12 * sum);
}

/// Sum over the contacts of overlap n x F.
Vec3<double> couple_of_full_arms(const Packing& p) {
  Vec3<double> sum;
  for (const Contact& c : p.contacts) sum += (c.overlap / norm(c.branch)) * cross(c.branch, c.force);
  return sum;
}

template <class Law>
class Spin : public testing::Test {};
TYPED_TEST_SUITE(Spin, EveryFrictionLaw, LawName);

// T22: an isolated cluster keeps its angular momentum when the lever arms meet in the contact, R - overlap/2.
// With the full radii each step changes it by -(dt/2) sum(overlap n x F) at its start and again at its end.
TYPED_TEST(Spin, AngularMomentumOfAClusterStays) {
  const auto simulation = make_simulation(model_of<TypeParam>({.friction = 0.5}), alone(cluster()));
  const Packing start = simulation->packing();
  double scale = 0;
  for (std::size_t k = 0; k < start.size(); ++k)
    scale += start.mass[k] * norm(start.unwrapped(k)) * norm(start.velocity[k]);
  ASSERT_GT(start.contacts.size(), 8u);
  Vec3<double> expected = angular_momentum(start);
  Vec3<double> couple = couple_of_full_arms(start);
  double torque = 0;
  for (int step = 0; step < 300; ++step) {
    simulation->advance(1);
    const Packing p = simulation->packing();
    if (!TypeParam::synchronized) expected -= (paper_step / 2) * (couple + couple_of_full_arms(p));
    couple = couple_of_full_arms(p);
    torque += norm(couple);
    ASSERT_LT(norm(angular_momentum(p) - expected), 1e-12 * scale) << step;
  }
  EXPECT_GT(torque, 1e-2);
}

}  // namespace
}  // namespace furnas
