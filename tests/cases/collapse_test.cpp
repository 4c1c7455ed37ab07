#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cases/program/run/recording.h"
#include "engine/state/validate.h"
#include "tests/cases/runs.h"

namespace furnas {
namespace {

using testing::HasSubstr;
using Json = nlohmann::json;

/// Ends with its own exit code, says why, and leaves a state from which one may go on.
void expect_clean_stop(const std::vector<std::string>& set, const char* reason) {
  const Runs runs;
  const Answer answer = runs.run("a", set);
  EXPECT_EQ(answer.code, ExitCode::numerical_failure);
  EXPECT_EQ(answer.err, "");
  EXPECT_THAT(answer.out, HasSubstr("verdict   diverged"));
  const Json result = runs.result("a");
  EXPECT_EQ(result["verdict"], "diverged");
  EXPECT_TRUE(result["phi_J"].is_null());
  EXPECT_THAT(std::string(result["reason"]), HasSubstr(reason));
  const Checkpoint good = Checkpoints::read_newest(runs.path("a"));
  EXPECT_NO_THROW(validate(good.packing));
  EXPECT_LT(good.packing.fraction_filled(), 1);
  EXPECT_EQ(runs.resume("a").code, ExitCode::numerical_failure);
}

TEST(Collapse, ACellThatIsTooLightIsNoNumberSoon) {
  expect_clean_stop({"compaction.pressure=0.1", "compaction.inertia=1e-12"},
                    "the edges of the cell are no numbers any more");
}

TEST(Collapse, ACellThatIsPressedTooFastFallsIn) {
  expect_clean_stop({"compaction.pressure=0.1", "compaction.inertia=1e-3", "mixture.start_fraction=0.001"},
                    "at step");
}

/// A checkpoint asked for at every look must not hold a state that is none.
TEST(Collapse, NeverGoesIntoACheckpoint) {
  expect_clean_stop({"compaction.pressure=0.1", "compaction.inertia=1e-3", "mixture.start_fraction=0.001",
                     "output.checkpoint_minutes=1e-6"},
                    "at step");
}

TEST(Collapse, ATinyPressureOnlySpendsItsBudget) {
  const Runs runs;
  const Answer answer = runs.run("a", {"compaction.pressure=1e-12", "stop.steps=3000"});
  EXPECT_EQ(answer.code, ExitCode::budget_spent);
  const Json result = runs.result("a");
  EXPECT_NEAR(result["phi"], 0.2, 1e-3);
  EXPECT_EQ(result["contacts"], 0);
  EXPECT_TRUE(result["force_imbalance"].is_null());
}

}  // namespace
}  // namespace furnas
