#include "cases/program/run/forecast.h"

#include <gtest/gtest.h>

#include <cmath>

namespace furnas {
namespace {

constexpr std::int64_t whole_window = 3000;

/// Criteria at so many times their limits.
RestReport times_the_limits(double stress, double balance, double energy, double drift) {
  const RestCriteria limits;
  RestReport report;
  report.backbone = 100;
  report.stress_error = stress * limits.stress_error;
  report.force_imbalance = balance * limits.force_imbalance;
  report.kinetic_energy = energy * limits.kinetic_energy;
  report.strain_drift = drift * limits.strain_drift;
  return report;
}

/// All but the drift hold; that falls by a power of ten in 10 000 steps, and is 10^(4 - step/10 000) limits.
Forecast falling_drift(std::int64_t steps) {
  Forecast forecast({}, whole_window, false);
  for (std::int64_t step = 300; step <= steps; step += 300)
    forecast.add(step,
                 times_the_limits(0.1, 0.1, 0.1, std::pow(10.0, 4 - static_cast<double>(step) / 10000)));
  return forecast;
}

TEST(Forecast, FollowsAnExponentialToItsLimit) {
  const auto left = falling_drift(15'000).left();
  ASSERT_TRUE(left);
  EXPECT_NEAR(left->likely, 25'000, 1) << "ten thousand steps for each of 2.5 powers of ten";
  EXPECT_NEAR(left->low, 12'500, 1);
  EXPECT_NEAR(left->high, 37'500, 2);
}

TEST(Forecast, AddsTheWindowForAllButTheDrift) {
  Forecast forecast({}, whole_window, false);
  for (std::int64_t step = 300; step <= 15'000; step += 300)
    forecast.add(step,
                 times_the_limits(0.1, std::pow(10.0, 2 - static_cast<double>(step) / 10000), 0.1, 0.1));
  EXPECT_NEAR(forecast.left()->likely, 5'000 + whole_window, 1);
}

TEST(Forecast, CountsWhatIsLeftOfTheWindow) {
  Forecast forecast({}, whole_window, false);
  for (std::int64_t step = 300; step <= 6'000; step += 300)
    forecast.add(step, times_the_limits(0.1, step < 5'100 ? 10 : 0.5, 0.1, 0.1));
  EXPECT_DOUBLE_EQ(forecast.left()->likely, whole_window - 900);
}

TEST(Forecast, SaysNothingBeforeThePackingCarries) {
  Forecast forecast({}, whole_window, false);
  for (std::int64_t step = 300; step <= 30'000; step += 300)
    forecast.add(step, times_the_limits(900, 1, 1, 1));
  EXPECT_FALSE(forecast.left());
  EXPECT_FALSE(falling_drift(3'000).left()) << "ten looks are no trend";
}

TEST(Forecast, HasNoEndWhereACriterionDoesNotFall) {
  Forecast forecast({}, whole_window, false);
  for (std::int64_t step = 300; step <= 15'000; step += 300) forecast.add(step, times_the_limits(5, 1, 1, 1));
  EXPECT_TRUE(std::isinf(forecast.left()->high));
  EXPECT_EQ(forecast.trend(0), Trend::stands);
  EXPECT_EQ(falling_drift(15'000).trend(3), Trend::falls);
}

TEST(Forecast, ForgetsEverySecondLookOfALongRun) {
  const auto left = falling_drift(300 * 2000).left();
  ASSERT_TRUE(left) << "of a drift long below its limit nothing is left but the whole_window that has passed";
  EXPECT_EQ(left->likely, 0);
}

}  // namespace
}  // namespace furnas
