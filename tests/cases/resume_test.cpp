#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <nlohmann/json.hpp>
#include <thread>

#include "cases/program/run/recording.h"
#include "engine/state/fingerprint.h"
#include "tests/cases/runs.h"
#include "tests/cases/same_run.h"

namespace furnas {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using Json = nlohmann::json;

TEST(ReliableResume, GoesOnToTheSameBits) {
  const Runs runs;
  ASSERT_EQ(runs.run("whole", {"stop.steps=6000"}).code, ExitCode::budget_spent);
  ASSERT_EQ(runs.run("parts", {"stop.steps=1234"}).code, ExitCode::budget_spent);
  for (const char* steps : {"1235", "3001", "6000"})
    ASSERT_EQ(runs.resume("parts", {"--steps", steps}).code, ExitCode::budget_spent);
  EXPECT_EQ(difference(runs.path("parts"), runs.path("whole")), "");
}

/// The last windows before rest are the hard part: looks, quenches and the verdict depend on them.
TEST(ReliableResume, ComesToRestAtTheSameStep) {
  const Runs runs;
  ASSERT_EQ(runs.run("whole").code, ExitCode::done);
  const int end = runs.result("whole")["steps"];
  std::string last = "0";
  ASSERT_EQ(runs.run("parts", {"stop.steps=" + std::to_string(end - 4321)}).code, ExitCode::budget_spent);
  for (int before : {2500, 1017, 1000, 731, 100, 99, 1})
    ASSERT_EQ(runs.resume("parts", {"--steps", std::to_string(end - before)}).code, ExitCode::budget_spent)
        << before;
  ASSERT_EQ(runs.resume("parts", {"--steps", "200000"}).code, ExitCode::done);
  EXPECT_EQ(difference(runs.path("parts"), runs.path("whole")), "");
}

TEST(ReliableResume, GoesOnWithItsStaircase) {
  const Runs runs;
  const std::string pressures = "compaction.pressure=[5e-4, 1e-3, 4e-3]";
  ASSERT_EQ(runs.run("whole", {pressures}).code, ExitCode::done);
  const Json states = runs.result("whole")["resting_states"];
  const int first = states[0]["step"];
  const int second = states[1]["step"];
  ASSERT_EQ(runs.run("parts", {pressures, "stop.steps=" + std::to_string(first + 55)}).code,
            ExitCode::budget_spent);
  EXPECT_EQ(runs.result("parts")["resting_states"].size(), 1u);
  EXPECT_EQ(runs.result("parts")["applied_pressure"], 1e-3);
  ASSERT_EQ(runs.resume("parts", {"--steps", std::to_string(second)}).code, ExitCode::budget_spent);
  ASSERT_EQ(runs.resume("parts", {"--steps", "200000"}).code, ExitCode::done);
  EXPECT_EQ(difference(runs.path("parts"), runs.path("whole")), "");
}

/// Fewer steps than are done would leave a run that nothing takes up again.
TEST(ReliableResume, NeverAsksForFewerStepsThanAreDone) {
  const Runs runs;
  ASSERT_EQ(runs.run("whole", {"stop.steps=900"}).code, ExitCode::budget_spent);
  ASSERT_EQ(runs.run("parts", {"stop.steps=500"}).code, ExitCode::budget_spent);
  const Answer fewer = runs.resume("parts", {"--steps", "499"});
  EXPECT_EQ(fewer.code, ExitCode::bad_case);
  EXPECT_THAT(fewer.err,
              HasSubstr("stop.steps = 499, but 500 steps are done; allowed: at least 500, or --more"));
  EXPECT_EQ(runs.resume("parts", {"--steps", "800", "--more", "1"}).code, ExitCode::bad_case);
  for (const char* too_many : {"2000000000000", "9223372036854775807"}) {
    const Answer answer = runs.resume("parts", {"--more", too_many});
    EXPECT_EQ(answer.code, ExitCode::bad_case);
    EXPECT_THAT(answer.err, HasSubstr("stop.steps"));
  }
  ASSERT_EQ(runs.resume("parts", {"--more", "400"}).code, ExitCode::budget_spent);
  EXPECT_EQ(difference(runs.path("parts"), runs.path("whole")), "");
}

TEST(ReliableResume, NeedsACheckpoint) {
  const Runs runs;
  fs::create_directory(runs.path("empty"));
  const Answer answer = runs.resume("empty");
  EXPECT_EQ(answer.code, ExitCode::bad_case);
  EXPECT_THAT(answer.err, HasSubstr("holds no checkpoint"));
  write_file(runs.path("empty/a.checkpoint"), "damaged");
  EXPECT_THAT(runs.resume("empty").err, HasSubstr("a.checkpoint"));
}

TEST(ReliableResume, FallsBackToTheOlderCheckpoint) {
  const Runs runs;
  ASSERT_EQ(runs.run("a", {"stop.steps=500"}).code, ExitCode::budget_spent);
  ASSERT_EQ(runs.resume("a", {"--steps", "700"}).code, ExitCode::budget_spent);
  const Packing newest = Checkpoints::read_newest(runs.path("a")).packing;
  EXPECT_EQ(newest.step, 700);
  for (const char* file : {"a/a.checkpoint", "a/b.checkpoint"}) {
    std::string bytes = content(runs.path(file));
    if (read_checkpoint(runs.path(file)).packing.step != 700) continue;
    bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
    write_file(runs.path(file), bytes);
    break;
  }
  EXPECT_EQ(Checkpoints::read_newest(runs.path("a")).packing.step, 500);
  ASSERT_EQ(runs.resume("a", {"--steps", "700"}).code, ExitCode::budget_spent);
  EXPECT_EQ(runs.result("a")["state_hash"], hex(state_hash(newest)));
}

/// Sends a signal to this process once the run has written a few rows of its history, unless it has ended.
std::jthread signal_during(const Runs& runs, int signal, const std::string& name) {
  return std::jthread([=, folder = fs::path(runs.path(name))](const std::stop_token& stop) {
    const auto begun = [&] {
      std::error_code missing;
      const auto size = fs::file_size(folder / "history.csv", missing);
      return !missing && size > 2000;
    };
    while (!begun()) {
      if (stop.stop_requested()) return;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    if (!fs::exists(folder / "result.json")) ::kill(::getpid(), signal);
  });
}

TEST(ReliableSignals, SaveAndStop) {
  const Runs runs;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const std::string name = "stopped by " + std::to_string(signal);
    const std::jthread sender = signal_during(runs, signal, name);
    const Answer answer = runs.run(name, {"stop.steps=100_000_000", "compaction.cell=fixed"});
    ASSERT_EQ(answer.code, ExitCode::interrupted);
    EXPECT_THAT(answer.out, HasSubstr("interrupted"));
    const Json result = runs.result(name);
    EXPECT_EQ(result["verdict"], "interrupted");
    EXPECT_EQ(result["state_hash"], hex(state_hash(Checkpoints::read_newest(runs.path(name)).packing)));
  }
}

/// Stopped anywhere and resumed, it ends as if nobody had stopped it.
TEST(ReliableSignals, AStoppedRunGoesOnToTheSameBits) {
  const Runs runs;
  ASSERT_EQ(runs.run("whole", {"stop.steps=40_000", "stop.kinetic_energy=1e-30"}).code,
            ExitCode::budget_spent);
  {
    const std::jthread sender = signal_during(runs, SIGINT, "parts");
    ASSERT_EQ(runs.run("parts", {"stop.steps=40_000", "stop.kinetic_energy=1e-30"}).code,
              ExitCode::interrupted);
  }
  ASSERT_EQ(runs.resume("parts").code, ExitCode::budget_spent);
  EXPECT_EQ(difference(runs.path("parts"), runs.path("whole")), "");
}

/// SIGUSR1 saves a checkpoint and leaves no other trace.
TEST(ReliableSignals, SaveAndGoOn) {
  const Runs runs;
  const std::vector<std::string> set{"stop.steps=40_000", "stop.kinetic_energy=1e-30"};
  ASSERT_EQ(runs.run("whole", set).code, ExitCode::budget_spent);
  {
    const std::jthread sender = signal_during(runs, SIGUSR1, "saved");
    ASSERT_EQ(runs.run("saved", set).code, ExitCode::budget_spent);
  }
  const auto older = std::min(read_checkpoint(runs.path("saved/a.checkpoint")).packing.step,
                              read_checkpoint(runs.path("saved/b.checkpoint")).packing.step);
  EXPECT_GT(older, 0) << "the first checkpoint was written over";
  EXPECT_LT(older, 40'000);
  EXPECT_EQ(difference(runs.path("saved"), runs.path("whole")), "");
}

}  // namespace
}  // namespace furnas
