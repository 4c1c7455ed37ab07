#include <gtest/gtest.h>

#include <sstream>

#include "cases/program/run/onlookers.h"
#include "io/case_protocol.h"
#include "tests/engine/fake_simulation.h"
#include "tests/io/packings.h"

namespace furnas {
namespace {

using std::chrono::seconds;

/// Whether a run ends at once that has so much time left, and whose slowest checkpoint took so long. Where
/// the answer is no, two hours are left, so that a busy machine gives the same.
bool ends(seconds left, seconds checkpoint) {
  const Case c;
  const TemporaryFolder folder;
  std::ostringstream out;
  LiveLines lines(out, false);
  Requests requests;
  RestWatch watch(protocol_of(c).rest, Rhythm(0.02));
  Checkpoints checkpoints(folder / "", "a.checkpoint", static_cast<double>(checkpoint.count()));
  RunContext run{.resolved_case = c,
                 .folder = folder / "",
                 .save = [] {},
                 .first_step = 0,
                 .deadline = std::chrono::steady_clock::now() + left,
                 .lines = lines,
                 .requests = requests,
                 .watch = watch,
                 .checkpoints = checkpoints};
  const Events limits = onlookers_of(run).limits;
  FakeSimulation simulation([](std::int64_t) { return Packing(); });
  Observation now(simulation, 3);
  EXPECT_STREQ(limits.front()->name(), "wall time");
  return limits.front()->due(now);
}

TEST(WallTime, IsSpentAtItsDeadline) {
  EXPECT_TRUE(ends(seconds(0), seconds(0)));
  EXPECT_FALSE(ends(seconds(100'000), seconds(0)));
}

TEST(WallTime, LeavesTwiceWhatTheSlowestCheckpointTook) {
  EXPECT_TRUE(ends(seconds(100'000), seconds(50'000)));
  EXPECT_FALSE(ends(seconds(100'000), seconds(45'000)));
}

TEST(WallTime, LeavesAHundredthForABusyMachineButTenSecondsAtMost) {
  EXPECT_TRUE(ends(seconds(600), seconds(298)));         // 6 s instead of 4 s
  EXPECT_TRUE(ends(seconds(100'000), seconds(49'996)));  // 10 s instead of 8 s
}

}  // namespace
}  // namespace furnas
