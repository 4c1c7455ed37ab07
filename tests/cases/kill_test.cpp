#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <iostream>
#include <nlohmann/json.hpp>
#include <random>
#include <thread>

#include "cases/program/run/recording.h"
#include "tests/cases/process.h"
#include "tests/cases/runs.h"
#include "tests/cases/same_run.h"

namespace furnas {
namespace {

namespace fs = std::filesystem;
using std::chrono::duration;
using testing::HasSubstr;
using Clock = std::chrono::steady_clock;

/// It saves whenever a hundredth of a second has passed, so that about every other kill meets a checkpoint
/// that is being written.
constexpr const char* saving_case = R"([mixture]
large = 60
start_fraction = 0.25
[stop]
steps = 12_000
kinetic_energy = 1e-30
[compute]
threads = 1
[output]
history_every = 50
snapshot_every = 3000
checkpoint_minutes = 1e-5
picture = "none"
)";

/// The same without friction, brought to rest by the minimizer.
constexpr const char* minimizing_case = R"([mixture]
large = 100
start_fraction = 0.25
[contact]
friction = 0
[compute]
threads = 1
[output]
history_every = 50
checkpoint_minutes = 1e-5
picture = "none"
)";

/// The step of the last whole row of a history; 0 if there is none.
std::int64_t last_row(const fs::path& history) {
  const std::string text = content(history);
  const auto end = text.rfind('\n');
  if (end == std::string::npos || end == 0) return 0;
  const auto begin = text.rfind('\n', end - 1);
  return begin == std::string::npos ? 0 : std::atoll(text.c_str() + begin + 1);
}

/// What a campaign of kills has come to.
struct Toll {
  int kills = 0;
  int runs = 0;           ///< that came to their end
  int half_written = 0;   ///< kills that left a checkpoint half written
  std::int64_t lost = 0;  ///< most steps between the last row and the checkpoint
};

/// Kills and resumes until `kills` have hit; each run that comes to its end must be the one nobody killed.
class Killing {
 public:
  /// The run of the case ends with the exit code `end`.
  Killing(unsigned seed, const char* case_text, int end) : runs_(case_text), end_(end), random_(seed) {
    const auto begin = Clock::now();
    EXPECT_EQ(ending_of({"run", runs_.path("case.toml"), "--out", runs_.path("whole")}).code, end_);
    whole_ = Clock::now() - begin;
  }

  Toll kill(int kills) {
    while (toll_.kills < kills && !testing::Test::HasFailure()) one();
    finish();
    return toll_;
  }

 private:
  bool saved() const {
    return fs::exists(runs_.path("run/a.checkpoint")) || fs::exists(runs_.path("run/b.checkpoint"));
  }
  std::vector<std::string> arguments() const {
    if (!saved()) return {"run", runs_.path("case.toml"), "--out", runs_.path("run")};
    // Another number of threads each time: it changes no bit.
    return {"resume", runs_.path("run"), "--threads", std::to_string(1 + toll_.kills % 3)};
  }

  void one() {
    if (!saved()) fs::remove_all(runs_.path("run"));
    Process process(arguments());
    std::this_thread::sleep_for(whole_ * std::uniform_real_distribution(0.0, 0.6)(random_));
    if (!process.runs()) return finished(process.wait());
    process.signal(SIGKILL);
    if (process.wait().signal == SIGKILL) ++toll_.kills;
    if (!saved()) return;
    const auto found = Checkpoints::find_newest(runs_.path("run"));
    EXPECT_EQ(found.fault, "") << "a checkpoint under its own name is whole";
    for (const char* name : {"a.checkpoint.tmp", "b.checkpoint.tmp"})
      toll_.half_written += fs::exists(runs_.path("run") + "/" + name);
    const std::int64_t lost = last_row(runs_.path("run/history.csv")) - found.checkpoint.packing.step;
    toll_.lost = std::max(toll_.lost, lost);
  }

  void finish() {
    if (!saved()) fs::remove_all(runs_.path("run"));
    finished(ending_of(arguments()));
  }

  void finished(const Ending& ending) {
    EXPECT_EQ(ending.code, end_) << ending.out;
    EXPECT_EQ(difference(runs_.path("whole"), runs_.path("run")), "");
    EXPECT_EQ(Runs::unfinished(runs_.path("run")), 0u);
    fs::remove_all(runs_.path("run"));
    ++toll_.runs;
  }

  const Runs runs_;
  int end_;
  std::mt19937_64 random_;
  duration<double> whole_{};
  Toll toll_;
};

Toll expect_survived(unsigned seed, int kills, const char* case_text = saving_case, int end = 5) {
  const Toll toll = Killing(seed, case_text, end).kill(kills);
  EXPECT_GE(toll.kills, kills);
  EXPECT_GE(toll.runs, 1);
  std::cout << "kills survived: " << toll.kills
            << ", of them inside the writing of a checkpoint: " << toll.half_written
            << "; runs brought to their end: " << toll.runs
            << "; most steps behind the last row: " << toll.lost << '\n';
  return toll;
}

TEST(ReliableKill, TwentyKillsChangeNothing) { expect_survived(1, 20); }
TEST(ReliableKill, ASearchForAMinimumGoesOn) { expect_survived(3, 8, minimizing_case, 0); }
TEST(NightlyKill, AThousandKillsChangeNothing) {
  EXPECT_GT(expect_survived(2, 1000).half_written, 0) << "no kill met the writing of a checkpoint";
}

/// Starts a run that would go on for ever and waits until it has written some rows.
std::unique_ptr<Process> endless(const Runs& runs, const std::vector<std::string>& more = {}) {
  std::vector<std::string> arguments{
      "run",   runs.path("case.toml"),     "--out", runs.path("run"),
      "--set", "stop.steps=1_000_000_000", "--set", "output.checkpoint_minutes=1000"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  auto process = std::make_unique<Process>(arguments);
  while (process->runs() && last_row(runs.path("run/history.csv")) < 1000)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  return process;
}

/// Within a step, saved, with an exit code of its own.
TEST(ReliableProcess, ASignalSavesAndStops) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGXCPU}) {
    const Runs runs(saving_case);
    const auto process = endless(runs);
    process->signal(signal);
    const Ending ending = process->wait();
    EXPECT_EQ(ending.code, 130) << signal << ending.out;
    EXPECT_THAT(ending.out, HasSubstr("verdict   interrupted"));
    EXPECT_EQ(runs.result("run")["steps"], Checkpoints::read_newest(runs.path("run")).packing.step);
    EXPECT_EQ(Runs::unfinished(runs.path("run")), 0u);
  }
}

/// SIGUSR1 saves; the kill that follows loses only what came after.
TEST(ReliableProcess, SIGUSR1SavesAndGoesOn) {
  const Runs runs(saving_case);
  const auto process = endless(runs);
  EXPECT_EQ(Checkpoints::read_newest(runs.path("run")).packing.step, 0);
  process->signal(SIGUSR1);
  const auto begin = Clock::now();
  while (Checkpoints::read_newest(runs.path("run")).packing.step == 0 &&
         Clock::now() - begin < std::chrono::seconds(60))
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  EXPECT_TRUE(process->runs());
  EXPECT_GE(Checkpoints::read_newest(runs.path("run")).packing.step, 1000);
  process->signal(SIGKILL);
  process->wait();
}

/// What the shell has asked to be ignored stays ignored: a run under nohup outlives its terminal.
TEST(ReliableProcess, NohupIsHeeded) {
  const Runs runs(saving_case);
  const auto before = std::signal(SIGHUP, SIG_IGN);
  const auto process = endless(runs);
  std::signal(SIGHUP, before);
  process->signal(SIGHUP);
  const std::int64_t row = last_row(runs.path("run/history.csv"));
  const auto begin = Clock::now();
  while (last_row(runs.path("run/history.csv")) < row + 500 &&
         Clock::now() - begin < std::chrono::seconds(60))
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  EXPECT_TRUE(process->runs());
  process->signal(SIGTERM);
  EXPECT_EQ(process->wait().code, 130);
}

/// Signals that come at any time, checkpoints included, leave a run that goes on to the same files.
TEST(ReliableProcess, SignalsAtAnyTimeChangeNothing) {
  const Runs runs(saving_case);
  ASSERT_EQ(ending_of({"run", runs.path("case.toml"), "--out", runs.path("whole")}).code, 5);
  std::mt19937_64 random(3);
  Ending ending =
      ending_of({"run", runs.path("case.toml"), "--out", runs.path("run"), "--set", "stop.steps=10"});
  const std::vector<std::string> on{"resume", runs.path("run"), "--steps", "12000"};
  int stops = 0;
  unsigned span = 60;  // within which both signals come [ms]; longer where a process takes longer to begin
  for (int n = 0; n < 20; ++n) {
    Process process(on);
    const fs::path lock = runs.path("run/run.lock");  // when it is there, the process has begun
    while (process.runs() && !fs::exists(lock)) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    std::this_thread::sleep_for(std::chrono::milliseconds(random() % span));
    process.signal(SIGUSR1);
    std::this_thread::sleep_for(std::chrono::milliseconds(random() % span));
    const int stop = n % 2 == 0 ? SIGTERM : SIGINT;
    process.signal(stop);
    ending = process.wait();
    // While it still reads its checkpoint it has nothing to save, and a signal ends it as it ends any
    // program.
    if (ending.code != 130 && ending.signal != stop) break;
    if (ending.signal == stop && stops == 0) span *= 2;
    stops += ending.code == 130;
  }
  EXPECT_GT(stops, 0);
  if (ending.code != 5) ending = ending_of(on);
  EXPECT_EQ(ending.code, 5) << ending.signal << ending.out;
  EXPECT_EQ(difference(runs.path("whole"), runs.path("run")), "");
}

/// Two processes in one folder: the second is refused and told by whom.
TEST(ReliableProcess, TwoInOneFolder) {
  const Runs runs(saving_case);
  const auto process = endless(runs);
  for (const auto& arguments :
       {std::vector<std::string>{"resume", runs.path("run")},
        std::vector<std::string>{"run", runs.path("case.toml"), "--out", runs.path("run")}}) {
    const Ending second = ending_of(arguments);
    EXPECT_TRUE(second.code == 8 || second.code == 2) << second.code << second.out;
    if (arguments.front() == "resume") {
      EXPECT_EQ(second.code, 8);
      EXPECT_THAT(second.out, HasSubstr("is in use: process "));
    }
  }
  EXPECT_TRUE(process->runs());
  process->signal(SIGINT);
  EXPECT_EQ(process->wait().code, 130);
  EXPECT_EQ(ending_of({"resume", runs.path("run"), "--more", "10"}).code, 5) << "the folder is free again";
}

/// Runs an endless case for two seconds, and expects all that it has done to be saved; its result.
nlohmann::json run_of_two_seconds(const Runs& runs) {
  const Ending ending = ending_of({"run", runs.path("case.toml"), "--out", runs.path("run"), "--set",
                                   "stop.steps=1_000_000_000", "--walltime", "2s"});
  EXPECT_EQ(ending.code, 5) << ending.out;
  const nlohmann::json result = runs.result("run");
  EXPECT_THAT(result["reason"].get<std::string>(), HasSubstr("the wall time is spent"));
  EXPECT_GT(result["steps"], 0);
  EXPECT_EQ(result["steps"], Checkpoints::read_newest(runs.path("run")).packing.step);
  EXPECT_EQ(Runs::unfinished(runs.path("run")), 0u);
  return result;
}

/// How long before the wall time a run must end is asked in tests/cases/run/wall_time_test.cpp.
TEST(ReliableProcess, AWallTimeSavesAndStops) {
  const Runs runs(saving_case);
  run_of_two_seconds(runs);
}

/// The wall time is a promise: the state is saved before it is over, where the machine is not too busy.
TEST(NightlyProcess, AWallTimeEndsInTime) {
  const Runs runs(saving_case);
  const double seconds = run_of_two_seconds(runs)["wall_seconds"];  // the last checkpoint included
  EXPECT_GT(seconds, 1.5);
  EXPECT_LT(seconds, 2.1);
}

}  // namespace
}  // namespace furnas
