#include "cases/program/run/schedule.h"

#include <gtest/gtest.h>

#include <sstream>

#include "cases/program/run/run_case.h"
#include "io/case_protocol.h"
#include "tests/io/packings.h"

namespace furnas {
namespace {

using Names = std::vector<std::string>;

/// The events of a run of this case, in their order.
Names events_of(const Case& c, bool walltime = false) {
  const TemporaryFolder folder;
  std::ostringstream out;
  Requests requests;
  RestWatch watch(rest_criteria_of(c));
  Checkpoints checkpoints(folder / "");
  std::vector<RestingState> reached;
  RunContext run{c,           folder / "", [] { return Checkpoint(); }, 0, {}, out, false, requests, watch,
                 checkpoints, reached};
  if (walltime) run.deadline = std::chrono::steady_clock::now();
  Names names;
  for (const auto& event : schedule(run)) names.emplace_back(event->name());
  return names;
}

/// What breaks comes first; what changes the state before what records it; a checkpoint after all of that,
/// because a run goes on behind the events of its step; what ends the run without a verdict last.
TEST(Schedule, HasItsOrder) {
  Case c;
  EXPECT_EQ(events_of(c), (Names{"monitor", "flip", "renew the order", "history", "next pressure", "at rest",
                                 "quench", "progress", "checkpoint", "budget", "interrupted"}));
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
  EXPECT_EQ(exit_code_of(Verdict::budget), ExitCode::budget_spent);
  EXPECT_EQ(exit_code_of(Verdict::diverged), ExitCode::numerical_failure);
  EXPECT_EQ(exit_code_of(Verdict::interrupted), ExitCode::interrupted);
}

TEST(Scenario, TheBathIsAsHeavyAsThePacking) {
  Case c;
  c.mixture.large = 64;
  const Packing packing = start_of(c);
  // W = beta M L^2/12 with L the edge of a cube that the spheres fill to 0.64; their density is 1.
  const double mass = packing.sphere_volume();
  EXPECT_NEAR(model_of(c, packing).barostat.inertia, mass * std::pow(mass / 0.64, 2.0 / 3) / 12,
              1e-12 * mass * mass);
  c.compaction.inertia = 2.5;
  EXPECT_NEAR(model_of(c, packing).barostat.inertia, 2.5 * mass * std::pow(mass / 0.64, 2.0 / 3) / 12,
              1e-12 * mass * mass);
  c.compaction.inertia_absolute = 7;
  EXPECT_EQ(model_of(c, packing).barostat.inertia, 7);
}

TEST(Scenario, TheLawFollowsFromNameAndFriction) {
  Case c;
  c.mixture.large = 2;
  const Packing packing = start_of(c);
  EXPECT_TRUE(std::holds_alternative<HookeSynchronized>(model_of(c, packing).law));
  EXPECT_EQ(backbone_threshold_of(c), 2);
  c.contact.law = "hooke_history";
  EXPECT_TRUE(std::holds_alternative<HookeHistory>(model_of(c, packing).law));
  EXPECT_TRUE(model_of(c, packing).barostat.legacy);
  c.contact.friction = 0;
  EXPECT_TRUE(std::holds_alternative<Frictionless<true>>(model_of(c, packing).law));
  EXPECT_EQ(backbone_threshold_of(c), 4);
  c.contact.law = "hooke_synchronized";
  EXPECT_TRUE(std::holds_alternative<Frictionless<false>>(model_of(c, packing).law));
  EXPECT_FALSE(model_of(c, packing).barostat.legacy);
}

TEST(Scenario, AStartFromAFileBeginsItsOwnClock) {
  Case c;
  c.start.file = test_data("a3.nph.mu0.3.dump");
  const Packing packing = start_of(c);
  EXPECT_EQ(packing.step, 0);
  EXPECT_EQ(packing.time, 0);
  EXPECT_GT(packing.size(), 0u);
}

}  // namespace
}  // namespace furnas
