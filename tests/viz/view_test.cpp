#include "viz/view.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "engine/base/require.h"

namespace furnas {
namespace {

struct Ball {
  Vec3<double> centre;
  double radius;
};

std::vector<Ball> some_balls() {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<Ball> balls;
  for (int k = 0; k < 60; ++k)
    balls.push_back(
        {{300 + 20 * unit(random), 10 * unit(random), -5 * unit(random)}, 0.1 + 2 * unit(random)});
  return balls;
}

/// The largest distance from the middle of the frame at which any of the balls' surfaces is seen, per side.
std::array<double, 2> extent(const View& view, const std::vector<Ball>& balls) {
  std::mt19937 random(11);
  std::normal_distribution<double> normal;
  std::array<double, 2> most{};
  for (const Ball& ball : balls)
    for (int k = 0; k < 4000; ++k) {
      Vec3<double> direction{normal(random), normal(random), normal(random)};
      direction *= ball.radius / norm(direction);
      const auto seen = view.project(ball.centre + direction);
      for (int c = 0; c < 2; ++c) most[c] = std::max(most[c], std::abs(seen[c]));
    }
  return most;
}

TEST(View, HoldsEverythingWithoutWaste) {
  for (const double aspect : {1.0, 2.5, 0.4}) {
    ViewFit fit(aspect);
    const std::vector<Ball> balls = some_balls();
    for (const Ball& ball : balls) fit.add(ball.centre, ball.radius);
    const View view = fit.view();
    const auto [x, y] = extent(view, balls);
    EXPECT_LT(std::max(x, y), 0.961) << "aspect " << aspect;
    EXPECT_GT(std::max(x, y), 0.95) << "aspect " << aspect;
    EXPECT_DOUBLE_EQ(view.slope_x / view.slope_y, aspect);
  }
}

TEST(View, DistancesEncloseTheScene) {
  ViewFit fit(1);
  const std::vector<Ball> balls = some_balls();
  for (const Ball& ball : balls) fit.add(ball.centre, ball.radius);
  const View view = fit.view();
  EXPECT_GT(view.nearest, 0);
  double nearest = 1e300, farthest = 0;
  for (const Ball& ball : balls) {
    const double depth = -dot(ball.centre - view.eye, view.toward);
    nearest = std::min(nearest, depth - ball.radius);
    farthest = std::max(farthest, depth + ball.radius);
  }
  EXPECT_NEAR(view.nearest, nearest, 1e-9);
  EXPECT_NEAR(view.farthest, farthest, 1e-9);
}

TEST(View, AxesAreOrthonormalAndRightHanded) {
  ViewFit fit(1);
  fit.add({0, 0, 0}, 1);
  const View view = fit.view();
  EXPECT_NEAR(norm(cross(view.right, view.up) - view.toward), 0, 1e-15);
  EXPECT_NEAR(norm(view.right), 1, 1e-15);
  EXPECT_NEAR(norm(view.up), 1, 1e-15);
  EXPECT_GT(view.up.z, 0);
}

TEST(View, NeedsSomethingToLookAt) { EXPECT_THROW(ViewFit(1).view(), ContractError); }

}  // namespace
}  // namespace furnas
