#include "engine/trials/groove.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <vector>

#include "tests/engine/laws/every_law.h"

namespace furnas {
namespace {

constexpr double degree = Groove::degree;
constexpr double size_ratios[] = {2, 5, 10, 20, 40};
constexpr double escape_tolerance = 0.02;

double late(const Descent& descent, double expected) {
  return descent.escaped ? *descent.escaped / expected - 1 : INFINITY;
}

// T17: it rolls as a rigid sphere does, gets away, and no contact ever carries more than on the top. The
// spheres are softer than rigid by their overlap, load/ring < 1e-4.
TEST(Groove, SmallSphereRollsOutAsTheClosedFormSays) {
  for (double size_ratio : size_ratios) {
    const Groove groove{size_ratio, 1e-5, 0.5};
    const std::vector<double> angles{5 * degree, 15 * degree, 30 * degree};
    const Descent is = descend<HookeSynchronized>(groove, paper_step, angles);
    ASSERT_EQ(is.passed.size(), angles.size()) << size_ratio;
    for (std::size_t n = 0; n < angles.size(); ++n)
      EXPECT_NEAR(is.passed[n] / groove.rolling_time(angles[n]), 1, 1e-4) << size_ratio;
    EXPECT_TRUE(is.escaped) << size_ratio;
    EXPECT_LT(is.largest_load, 1 + 1e-3) << size_ratio;
  }
}

/// The legacy law sees the spin against the normal of the step's end and the velocity across its middle. In a
/// groove the two no longer cancel: each step adds a slip of speed^2 dt/(2 ring), always outwards. Where
/// friction holds a wedge of this angle, tan(half angle) < mu, it draws the sphere in until it sticks.
bool legacy_sticks(const Groove& groove) { return groove.wedge() < groove.friction; }

void compare_with_legacy(const Groove& groove, double reference_step) {
  const Descent reference = descend<HookeSynchronized>(groove, reference_step);
  ASSERT_TRUE(reference.escaped) << groove.size_ratio;
  const Descent synchronized = descend<HookeSynchronized>(groove, paper_step);
  const Descent legacy = descend<HookeHistory>(groove, paper_step);
  const double right = late(synchronized, *reference.escaped);
  const double wrong = late(legacy, *reference.escaped);
  std::cout << "size ratio " << groove.size_ratio << ", friction " << groove.friction << ", g "
            << groove.gravity << ": escapes late by " << right << " (synchronized), " << wrong
            << " (legacy); largest load " << synchronized.largest_load << ", " << legacy.largest_load << '\n';
  EXPECT_LT(std::abs(right), escape_tolerance) << groove.size_ratio;
  EXPECT_LT(synchronized.largest_load, 1 + 1e-3) << groove.size_ratio;
  if (legacy_sticks(groove))
    EXPECT_GT(wrong, escape_tolerance) << groove.size_ratio;
  else
    EXPECT_LT(std::abs(wrong), escape_tolerance) << groove.size_ratio;
  // Its contacts carry what is not there at any size ratio.
  EXPECT_GT(legacy.largest_load, 1.4) << groove.size_ratio;
}

// T17: the escape is on time to 2 % at the time step of the paper; the legacy law fails this wherever
// friction holds the wedge: with mu = 1 from a size ratio of 2.4 on, with mu = 0.5 from 8.5 on.
TEST(Groove, LegacySticksWhereSynchronizedEscapesOnTime) {
  for (double size_ratio : {2.0, 10.0}) compare_with_legacy({size_ratio, 1e-5, 0.5}, paper_step / 4);
  for (double size_ratio : {2.0, 5.0}) compare_with_legacy({size_ratio, 1e-5, 1}, paper_step / 4);
}

// T17: with the weight of the published example (m g/(k_n d_s) = 3.2e-7), against a 64th of the step.
TEST(NightlyGroove, LegacySticksWhereSynchronizedEscapesOnTime) {
  for (double size_ratio : size_ratios) compare_with_legacy({size_ratio, 6.13e-7, 0.5}, paper_step / 64);
}

// T17: the trajectory converges to that of a 64th of the step. A first order of 1e-9 is left of the start:
// friction is first felt at the end of the first step.
TEST(NightlyGroove, TrajectoryConverges) {
  const std::vector<double> angles{5 * degree, 15 * degree, 30 * degree, 45 * degree};
  for (double size_ratio : size_ratios) {
    const Groove groove{size_ratio, 1e-4, 0.5};
    const auto passed = [&](int divisions) {
      return descend<HookeSynchronized>(groove, paper_step / divisions, angles).passed;
    };
    const std::vector<double> reference = passed(64);
    const auto error = [&](int divisions) {
      const std::vector<double> is = passed(divisions);
      double worst = 0;
      for (std::size_t n = 0; n < angles.size(); ++n)
        worst = std::max(worst, std::abs(is.at(n) / reference.at(n) - 1));
      return worst;
    };
    EXPECT_LT(error(1), 1e-8) << size_ratio;
    EXPECT_LT(error(4), 0.5 * error(1)) << size_ratio;
  }
}

}  // namespace
}  // namespace furnas
