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

// The squares of {1, 3} and {10, 14} from their means are 2 and 8, with two degrees; t(2) = 4.30265.
TEST(PooledDeviation, FollowsTheClosedForm) {
  PooledDeviation pooled;
  EXPECT_TRUE(std::isinf(pooled.half_width(1)));
  pooled.add(mean_interval({5}));
  EXPECT_TRUE(std::isinf(pooled.half_width(1))) << "a lone sample tells nothing of its scatter";
  pooled.add(mean_interval({1, 3}));
  pooled.add(mean_interval({10, 14}));
  EXPECT_EQ(pooled.degrees_of_freedom(), 2u);
  EXPECT_NEAR(pooled.value(), std::sqrt(5.0), 1e-14);
  EXPECT_NEAR(pooled.half_width(1), 4.30265 * std::sqrt(5.0), 1e-4);
  EXPECT_NEAR(pooled.half_width(4, 3), 1.5 * pooled.half_width(1), 1e-12);
}

/// Of one group it is the interval of that group.
TEST(PooledDeviation, OfOneGroupIsStudents) {
  const MeanInterval group = mean_interval({1, 2, 4, 7});
  PooledDeviation pooled;
  pooled.add(group, 0.1);
  EXPECT_NEAR(pooled.half_width(4, 0.1), group.half_width, 1e-12);
}

/// 90 % intervals of a lone sample must hold its mean in 90 % of 4000 experiments, within four standard
/// errors, when groups of other sizes scatter as N^-1/2.
TEST(PooledDeviation, HoldsTheMeanAsOftenAsItSays) {
  std::mt19937_64 random(2);
  const auto sample = [&](double mean, double size) {
    return std::normal_distribution<double>(mean, 0.05 / std::sqrt(size))(random);
  };
  constexpr int experiments = 4000;
  int hits = 0;
  for (int n = 0; n < experiments; ++n) {
    PooledDeviation pooled;
    for (const double size : {10.0, 50.0, 200.0})
      pooled.add(mean_interval({sample(size, size), sample(size, size)}), 1 / std::sqrt(size));
    hits += std::abs(sample(0.8, 40) - 0.8) < pooled.half_width(1, 1 / std::sqrt(40.0), 0.9);
  }
  EXPECT_NEAR(static_cast<double>(hits) / experiments, 0.9, 4 * std::sqrt(0.9 * 0.1 / experiments));
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
