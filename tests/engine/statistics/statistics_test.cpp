#include "engine/statistics/statistics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "engine/base/require.h"

namespace furnas {
namespace {

/// t(0.975) of 1, 4 and 19 degrees from printed tables.
TEST(MeanInterval, IsStudents) {
  const MeanInterval two = mean_interval({1, 3});
  EXPECT_EQ(two.mean, 2);
  EXPECT_NEAR(two.deviation, std::sqrt(2.0), 1e-15);
  EXPECT_NEAR(two.half_width, 12.7062, 1e-4);  // s/sqrt(n) = 1
  const MeanInterval five = mean_interval({1, 2, 3, 4, 5});
  EXPECT_NEAR(five.half_width, 2.77645 * std::sqrt(2.5 / 5), 1e-5);
  std::vector<double> twenty(20, 7);
  twenty[0] = 8;
  const double s = std::sqrt((1.0 - 1.0 / 20) / 19);
  EXPECT_NEAR(mean_interval(twenty).half_width, 2.09302 * s / std::sqrt(20.0), 1e-6);
}

TEST(MeanInterval, OfOneSampleKnowsNothing) {
  EXPECT_EQ(mean_interval({3}).mean, 3);
  EXPECT_TRUE(std::isinf(mean_interval({3}).half_width));
  EXPECT_TRUE(std::isinf(difference_interval({3}, {1, 2}).half_width));
  EXPECT_THROW(mean_interval({}), ContractError);
}

/// 90 % intervals must hold the truth in 90 % of 4000 experiments, within four standard errors.
TEST(MeanInterval, HoldsTheMeanAsOftenAsItSays) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal(5, 2);
  std::normal_distribution<double> wide(3, 6);
  int hits = 0;
  int difference_hits = 0;
  constexpr int experiments = 4000;
  for (int n = 0; n < experiments; ++n) {
    std::vector<double> a(4), b(8);
    for (double& x : a) x = normal(random);
    for (double& x : b) x = wide(random);
    const MeanInterval m = mean_interval(a, 0.9);
    hits += m.low() < 5 && 5 < m.high();
    const MeanInterval d = difference_interval(a, b, 0.9);
    difference_hits += d.low() < 2 && 2 < d.high();
  }
  const double error = 4 * std::sqrt(0.9 * 0.1 / experiments);
  EXPECT_NEAR(static_cast<double>(hits) / experiments, 0.9, error);
  EXPECT_NEAR(static_cast<double>(difference_hits) / experiments, 0.9, error);  // Welch: nearly exact
}

// y = 1 + 2x at x = 1, 2, 3 with residuals 0.1, -0.2, 0.1: s^2 = 0.06, s_0 = s (1/3 + 4/2)^(1/2), t(1)
// = 12.7062.
TEST(ValueAtZero, FollowsTheClosedForm) {
  const MeanInterval zero = value_at_zero({1, 2, 3}, {3.1, 4.8, 7.1});
  EXPECT_NEAR(zero.mean, 1, 1e-12);
  EXPECT_NEAR(zero.deviation, std::sqrt(0.06), 1e-12);
  EXPECT_NEAR(zero.half_width, 12.7062 * std::sqrt(0.06 * (1.0 / 3 + 2)), 1e-4);
  EXPECT_TRUE(std::isinf(value_at_zero({1, 2}, {3, 5}).half_width));
  EXPECT_THROW(value_at_zero({1, 1, 1}, {3, 5, 4}), ContractError);
}

/// As HoldsTheMeanAsOftenAsItSays, for a line.
TEST(ValueAtZero, HoldsTheValueAsOftenAsItSays) {
  std::mt19937_64 random(2);
  std::normal_distribution<double> noise(0, 3);
  int hits = 0;
  constexpr int experiments = 4000;
  for (int n = 0; n < experiments; ++n) {
    const std::vector<double> x{1, 1, 2, 2, 5, 5};
    std::vector<double> y;
    for (const double at : x) y.push_back(7 - 4 * at + noise(random));
    const MeanInterval zero = value_at_zero(x, y, 0.9);
    hits += zero.low() < 7 && 7 < zero.high();
  }
  EXPECT_NEAR(static_cast<double>(hits) / experiments, 0.9, 4 * std::sqrt(0.9 * 0.1 / experiments));
}

}  // namespace
}  // namespace furnas
