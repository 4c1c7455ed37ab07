#include "cases/program/expected_steps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <tuple>
#include <vector>

#include "cases/program/sweep/sample_table.h"
#include "tests/cases/study_tables.h"

namespace furnas {
namespace {

/// The median of the steps of the samples of each point of the study is within a factor of three of what
/// `furnas check` foretells.
TEST(ExpectedSteps, AreThoseOfTheStudyWithinAFactorOfThree) {
  std::map<std::tuple<double, double, double, std::int64_t, std::int64_t, bool>, std::vector<std::int64_t>>
      steps;
  for (const std::filesystem::path& table : study_tables())
    for (const SampleRow& row : read_sample_table(table).rows)
      if (row.jammed() || row.settled())
        steps[{row.size_ratio, row.small_fraction, row.friction, row.large, row.small, row.settled()}]
            .push_back(row.steps);
  ASSERT_GE(steps.size(), 100u);
  for (auto& [point, taken] : steps) {
    const auto& [alpha, f_s, friction, large, small, settled] = point;
    Case c;
    c.mixture.size_ratio = alpha;
    c.mixture.small_fraction = f_s;
    c.mixture.large = large;
    c.contact.friction = friction;
    c.stop.phi_error = settled ? 1e-2 : 0;
    const auto middle = taken.begin() + std::ssize(taken) / 2;
    std::nth_element(taken.begin(), middle, taken.end());
    const double ratio = expected_steps(c, static_cast<double>(large + small)) / static_cast<double>(*middle);
    EXPECT_GT(ratio, 1.0 / 3) << "size ratio " << alpha << ", f_s " << f_s << ", friction " << friction;
    EXPECT_LT(ratio, 3) << "size ratio " << alpha << ", f_s " << f_s << ", friction " << friction;
  }
}

TEST(ExpectedSteps, AreAtMostTheCap) {
  Case c;
  c.stop.steps = 1000;
  EXPECT_EQ(expected_steps(c, 1e6), 1000);
}

TEST(ExpectedSteps, GrowAsTheTimeStepFalls) {
  Case c;
  c.contact.friction = 0.3;
  c.compaction.time_step = 0.02;
  const double steps = expected_steps(c, 1000);
  c.compaction.time_step = 0.01;
  EXPECT_NEAR(expected_steps(c, 1000) / steps, 2, 1e-6);
}

}  // namespace
}  // namespace furnas
