#include "cases/program/sweep/time_left.h"

#include <gtest/gtest.h>

namespace furnas {
namespace {

constexpr double expected = 10;  // particle-steps a second

TEST(TimeLeft, IsThatOfTheExpectedPaceAtFirst) {
  EXPECT_DOUBLE_EQ(seconds_left({1000, 0, {}}, 0, expected), 100);
  EXPECT_DOUBLE_EQ(seconds_left({0, 0, {}}, 0, expected), 0);
}

// A worker of pace v does v t in t seconds; the expected pace counts like sixty of these seconds.
TEST(TimeLeft, FollowsThePaceSoFar) {
  for (const double pace : {1.0, 10.0, 100.0})
    for (const double seconds : {1.0, 60.0, 1e6}) {
      const double mixed = (pace * seconds + expected * 60) / (seconds + 60);
      EXPECT_DOUBLE_EQ(seconds_left({1000, pace * seconds, {}}, seconds, expected), 1000 / mixed);
    }
}

// One sample with a cost of 1000 runs, 300 of which were done before this turn, and 100 in it.
TEST(TimeLeft, CountsTheHeadStartAsDoneButNotAsPace) {
  const SweepWork work{1000, 0, {{1000, 300, 400}}};
  EXPECT_DOUBLE_EQ(seconds_left(work, 10, expected), 600 / ((100 + 600) / 70.0));
}

// A sample that has ended counts with its cost, less what was done before this turn.
TEST(TimeLeft, CountsNoWorkBelowZero) {
  EXPECT_DOUBLE_EQ((RunningWork{1000, 300, 1000}.in_this_turn()), 700);
  EXPECT_DOUBLE_EQ((RunningWork{1000, 300, 5000}.in_this_turn()), 700);
  EXPECT_DOUBLE_EQ((RunningWork{1000, 2000, 5000}.in_this_turn()), 0);
}

TEST(TimeLeft, LeavesOutWhatALateSampleDoesBeyondItsCost) {
  const RunningWork late{1000, 0, 5000};
  EXPECT_TRUE(late.late());
  EXPECT_FALSE((RunningWork{1000, 0, 1000}.late()));
  EXPECT_DOUBLE_EQ(seconds_left({1000, 0, {late}}, 40, expected), 0);
  EXPECT_DOUBLE_EQ(seconds_left({1500, 0, {late}}, 40, expected), 500 / ((1000 + 600) / 100.0));
  const RunningWork late_before{1000, 2000, 5000};
  EXPECT_DOUBLE_EQ(seconds_left({1500, 0, {late_before}}, 40, expected), 500 / (600 / 100.0));
}

}  // namespace
}  // namespace furnas
