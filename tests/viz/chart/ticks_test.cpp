#include "viz/chart/ticks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace furnas {
namespace {

using testing::ElementsAre;

std::vector<std::string> labels(const std::vector<Tick>& ticks) {
  std::vector<std::string> all;
  for (const Tick& tick : ticks)
    if (!tick.label.empty()) all.push_back(tick.label);
  return all;
}

TEST(Ticks, StandAtRoundNumbers) {
  EXPECT_THAT(labels(linear_ticks({0, 1}, 8)), ElementsAre("0.0", "0.2", "0.4", "0.6", "0.8", "1.0"));
  EXPECT_THAT(labels(linear_ticks({-3, 4}, 8)), ElementsAre("−3", "−2", "−1", "0", "1", "2", "3", "4"));
  EXPECT_THAT(labels(linear_ticks({0.61, 0.65}, 8)),
              ElementsAre("0.610", "0.615", "0.620", "0.625", "0.630", "0.635", "0.640", "0.645", "0.650"));
  EXPECT_THAT(labels(linear_ticks({0, 2.1e7}, 8)), ElementsAre("0", "5e+06", "1e+07", "1.5e+07", "2e+07"));
}

TEST(Ticks, AreNeverTooMany) {
  for (double length = 1e-7; length < 1e9; length *= 1.37)
    for (const double low : {0.0, -0.37 * length, 12.3 * length}) {
      const std::size_t count = linear_ticks({low, low + length}, 8).size();
      EXPECT_LE(count, 9U) << low << " + " << length;
      EXPECT_GE(count, 3U) << low << " + " << length;
    }
}

TEST(Ticks, AWidenedStretchEndsOnThem) {
  const Stretch wide = widened_to_ticks({0.123, 0.787}, 8);
  EXPECT_DOUBLE_EQ(wide.low, 0.1);
  EXPECT_DOUBLE_EQ(wide.high, 0.8);
  const Stretch same = widened_to_ticks({0.1, 0.8}, 8);
  EXPECT_DOUBLE_EQ(same.low, 0.1);
  EXPECT_DOUBLE_EQ(same.high, 0.8);
}

TEST(Ticks, OfALogarithmicAxisAreLabelledAtPowersOfTen) {
  const auto ticks = logarithmic_ticks({-5, 1}, 8);
  EXPECT_THAT(labels(ticks), ElementsAre("10^{−5}", "10^{−4}", "0.001", "0.01", "0.1", "1", "10"));
  EXPECT_EQ(ticks.size(), 6U * 9 + 1);
  EXPECT_NEAR(ticks[1].at, std::log10(2e-5), 1e-12);
  EXPECT_THAT(labels(logarithmic_ticks({std::log10(0.2), std::log10(5)}, 8)),
              ElementsAre("0.2", "0.5", "1", "2", "5"));
  EXPECT_THAT(labels(logarithmic_ticks({0, 20}, 8)),
              ElementsAre("1", "1000", "10^{6}", "10^{9}", "10^{12}", "10^{15}", "10^{18}"));
}

}  // namespace
}  // namespace furnas
