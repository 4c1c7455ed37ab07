#include "cases/program/run/onlookers.h"

#include <gtest/gtest.h>

#include <sstream>

#include "cases/program/run/run_case.h"
#include "io/case_protocol.h"
#include "tests/io/packings.h"

namespace furnas {
namespace {

using Names = std::vector<std::string>;

Names names_of(const Events& events) {
  Names names;
  for (const auto& event : events) names.emplace_back(event->name());
  return names;
}

/// All events of a run of this case, in their order.
Names events_of(const Case& c, bool walltime = false) {
  const TemporaryFolder folder;
  std::ostringstream out;
  LiveLines lines(out, false);
  Requests requests;
  const Protocol protocol = protocol_of(c);
  RestWatch watch(protocol.rest, Rhythm(0.02));
  Checkpoints checkpoints(folder / "");
  std::vector<RestingState> reached;
  RunContext run{.resolved_case = c,
                 .folder = folder / "",
                 .save = [] {},
                 .first_step = 0,
                 .deadline = {},
                 .lines = lines,
                 .requests = requests,
                 .watch = watch,
                 .checkpoints = checkpoints};
  if (walltime) run.deadline = std::chrono::steady_clock::now();
  return names_of(schedule(protocol, Rhythm(0.02), {}, watch, reached, onlookers_of(run)));
}

/// What breaks comes first; what changes the state before what records it; a checkpoint after all of that,
/// because a run goes on behind the events of its step; what ends the run without a verdict last.
TEST(Onlookers, TakeTheirTurnsAmongTheEventsOfTheProtocol) {
  Case c;
  EXPECT_EQ(events_of(c), (Names{"monitor", "flip", "renew the order", "history", "next pressure", "at rest",
                                 "quench", "settle", "progress", "checkpoint", "budget", "interrupted"}));
  c.output.snapshot_every = 10;
  c.stop.criterion = "paper";
  EXPECT_EQ(events_of(c, true),
            (Names{"monitor", "flip", "renew the order", "history", "frame", "next pressure", "at rest",
                   "progress", "checkpoint", "budget", "wall time", "interrupted"}));
  c.compaction.cell = "fixed";
  EXPECT_EQ(events_of(c), (Names{"monitor", "flip", "renew the order", "history", "frame", "progress",
                                 "checkpoint", "budget", "interrupted"}));
}

TEST(ExitCodes, TellTheVerdict) {
  EXPECT_EQ(exit_code_of(Verdict::jammed), ExitCode::done);
  EXPECT_EQ(exit_code_of(Verdict::settled), ExitCode::done);
  EXPECT_EQ(exit_code_of(Verdict::budget), ExitCode::budget_spent);
  EXPECT_EQ(exit_code_of(Verdict::diverged), ExitCode::numerical_failure);
  EXPECT_EQ(exit_code_of(Verdict::interrupted), ExitCode::interrupted);
}

}  // namespace
}  // namespace furnas
