#include "cases/program/replication.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "engine/base/require.h"
#include "io/checkpoint.h"
#include "tests/cases/process.h"
#include "tests/cases/runs.h"

namespace furnas {
namespace {

using testing::HasSubstr;

TEST(ReplicateTimes, ReadAsTheyAreWritten) {
  EXPECT_EQ(parse_times("2x3x10"), (Times{2, 3, 10}));
  EXPECT_EQ(text_of(parse_times("1x1x7")), "1x1x7");
  for (const char* wrong : {"", "2", "2x2", "2x2x2x2", "0x1x1", "-1x1x1", "2x2x2 ", "axbxc", "1e9x1x1"})
    EXPECT_THROW(parse_times(wrong), InputError) << wrong;
}

TEST(ReplicateCommand, RepeatsTheRunWithItsContactsAndItsCase) {
  const Runs runs;
  ASSERT_EQ(runs.run("a", {"stop.steps=3000", "compaction.inertia_absolute=100"}).code,
            ExitCode::budget_spent);
  const Answer answer =
      furnas({"replicate", runs.path("a"), runs.path("large.checkpoint"), "--times", "2x1x2"});
  ASSERT_EQ(answer.code, ExitCode::done) << answer.err;
  EXPECT_EQ(answer.out, runs.path("large.checkpoint") + "\n");
  const PackingSource one = packing_source(runs.path("a"));
  const PackingSource four = packing_source(runs.path("large.checkpoint"));
  EXPECT_EQ(four.packing.size(), 4 * one.packing.size());
  EXPECT_GT(one.packing.contacts.size(), 0U);
  EXPECT_EQ(four.packing.contacts.size(), 4 * one.packing.contacts.size());
  EXPECT_EQ(four.packing.step, one.packing.step);
  ASSERT_TRUE(four.of_case);
  EXPECT_NEAR(*four.of_case->compaction.inertia_absolute, 100 * std::pow(4, 5.0 / 3), 1e-9);

  // A run goes on with it: its contacts carry their forces from the first step.
  write_file(runs.path("b.toml"),
             "[start]\nfile = \"large.checkpoint\"\n[stop]\nsteps = 1\n[output]\npicture = \"none\"\n");
  const Answer run = furnas({"run", runs.path("b.toml"), "--out", runs.path("b")});
  ASSERT_EQ(run.code, ExitCode::budget_spent) << run.err;
  EXPECT_EQ(runs.result("b")["large"], 400);
}

TEST(ReplicateCommand, WritesAStartOrAnotherFormat) {
  const Runs runs;
  ASSERT_EQ(runs.run("a", {"stop.steps=3000"}).code, ExitCode::budget_spent);
  ASSERT_EQ(
      furnas({"replicate", runs.path("a"), runs.path("s.checkpoint"), "--times", "2x2x2", "--start"}).code,
      ExitCode::done);
  const Packing start = read_checkpoint(runs.path("s.checkpoint")).packing;
  EXPECT_EQ(start.size(), 800U);
  EXPECT_TRUE(start.contacts.empty() && start.order.empty());
  ASSERT_EQ(furnas({"replicate", runs.path("a"), runs.path("d.data"), "--times", "1x1x3"}).code,
            ExitCode::done);
  EXPECT_EQ(packing_source(runs.path("d.data")).packing.size(), 300U);
}

/// What is worked out while it is written is what a packing in memory would be.
TEST(ReplicateCommand, WritesTheBytesOfTheReplicateInMemory) {
  const Runs runs;
  ASSERT_EQ(runs.run("a", {"stop.steps=3000"}).code, ExitCode::budget_spent);
  const PackingSource source = packing_source(runs.path("a"));
  const Packing many = replicate(source.packing, {2, 3, 1});
  ASSERT_GT(many.contacts.size(), 0U);
  ASSERT_EQ(many.order.size(), many.size());
  write_replicate(source, {2, 3, 1}, runs.path("stream.checkpoint"));
  write_checkpoint({many, read_checkpoint(runs.path("stream.checkpoint")).case_text, {}},
                   runs.path("memory.checkpoint"));
  EXPECT_EQ(content(runs.path("stream.checkpoint")), content(runs.path("memory.checkpoint")));
}

/// The start of a run that needs more memory than this machine has can be written on it.
TEST(ReplicateCommand, NeedsNoMemoryForALargeStart) {
  const Runs runs;
  ASSERT_EQ(runs.run("a", {"stop.steps=1000"}).code, ExitCode::budget_spent);
  const auto peak = [&](const std::string& times) {
    const Ending ending =
        ending_of({"replicate", runs.path("a"), runs.path("l.checkpoint"), "--start", "--times", times});
    EXPECT_EQ(ending.code, 0) << ending.out;
    return ending.peak;
  };
  const double of_few = peak("1x1x1"), of_many = peak("20x20x10");  // 400 000 spheres, 140 bytes each
  EXPECT_LT(of_many, of_few + 20e6);
  EXPECT_EQ(checkpoint_step(runs.path("l.checkpoint")), 1000);
}

TEST(ReplicateCommand, RefusesBeforeItWorks) {
  const Runs runs;
  const Answer times = furnas({"replicate", test_data("a3.data"), runs.path("x.data"), "--times", "2"});
  EXPECT_EQ(times.code, ExitCode::bad_case);
  EXPECT_THAT(times.err, HasSubstr("such as 2x2x2"));
  EXPECT_EQ(furnas({"replicate", test_data("a3.data"), runs.path("x.pdb"), "--times", "2x2x2"}).code,
            ExitCode::bad_case);
  EXPECT_EQ(runs.files(), 1U);
}

}  // namespace
}  // namespace furnas
