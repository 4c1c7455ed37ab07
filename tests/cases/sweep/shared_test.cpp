#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <fstream>
#include <iostream>
#include <map>
#include <memory>
#include <random>
#include <sstream>
#include <thread>

#include "cases/program/exit_code.h"
#include "cases/program/sweep/sample_table.h"
#include "tests/cases/process.h"
#include "tests/io/packings.h"

namespace furnas {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using namespace std::chrono_literals;

/// Forty samples of a tenth of a second, saved often.
constexpr const char* forty_samples = R"([mixture]
large = 60
start_fraction = 0.2
[compaction]
pressure = 1e-3
drag = 0.0
time_step = 0.02
[stop]
stress_error = 1e-2
force_imbalance = 1e-2
kinetic_energy = 1e-8
strain_drift = 1e-3
window = 20
steps = 100_000
[output]
picture = "none"
checkpoint_minutes = 1e-4
[sweep]
"contact.friction" = [0.1, 0.2, 0.3, 0.4]
samples = 10
)";

/// Two samples of half a second, that end with their steps and are saved often.
constexpr const char* two_samples = R"([mixture]
large = 100
start_fraction = 0.25
[stop]
kinetic_energy = 1e-30
steps = 40_000
[output]
checkpoint_minutes = 1e-3
picture = "none"
[sweep]
samples = 2
)";

/// How a sweep of that ends.
constexpr int spent_steps = static_cast<int>(ExitCode::budget_spent);
constexpr int samples_left = static_cast<int>(ExitCode::samples_left);

/// A folder that several workers share, each on a machine of its own as far as it can see: its clocks are
/// days ahead of those of the others.
class SharedSweep {
 public:
  explicit SharedSweep(const std::string& text) { write_file(folder_ / "a.toml", text); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  std::unique_ptr<Process> worker(const std::string& out, int machine,
                                  const std::vector<std::string>& more = {}) const {
    std::vector<std::string> words{"sweep", path("a.toml"), "--out", path(out)};
    words.insert(words.end(), more.begin(), more.end());
    const auto unless_told = [&](const std::string& option, const std::string& value) {
      if (std::find(more.begin(), more.end(), option) == more.end())
        words.insert(words.end(), {option, value});
    };
    unless_told("--jobs", "1");
    unless_told("--takeover", "1s");
    return std::make_unique<Process>(
        words, std::map<std::string, std::string>{{"LD_PRELOAD", FURNAS_MACHINE_FAULTS},
                                                  {"FURNAS_OTHER_MACHINE", std::to_string(machine)}});
  }

  /// The tables but for the seconds that samples took.
  std::string tables(const std::string& out) const {
    SampleTable table = read_sample_table(path(out));
    for (SampleRow& row : table.rows) row.wall_seconds = 0;
    return csv(table) + content(path(out) + "/points.csv") + content(path(out) + "/maxima.csv");
  }

  /// How often the book says a word, for each sample.
  std::map<std::string, int> said(const std::string& out, const std::string& word) const {
    std::map<std::string, int> count;
    for (const auto& entry : fs::directory_iterator(path(out) + "/turns")) {
      const std::string name = entry.path().filename().string();
      count[name.substr(0, name.rfind('.'))] += content(entry.path()).starts_with(word);
    }
    return count;
  }

  /// Every sample has come to its end once, and is in its place.
  void expect_each_done_once(const std::string& out, std::size_t samples) const {
    const auto done = said(out, "done");
    EXPECT_EQ(done.size(), samples);
    for (const auto& [sample, times] : done) EXPECT_EQ(times, 1) << sample;
    for (const SampleRow& row : read_sample_table(path(out)).rows) EXPECT_NE(row.verdict, "unfinished");
  }

  /// Everything in the samples' folders, with its text.
  std::map<std::string, std::string> files(const std::string& out) const {
    std::map<std::string, std::string> all;
    for (const auto& entry : fs::recursive_directory_iterator(path(out) + "/samples"))
      if (entry.is_regular_file() && entry.path().string().find(".turn-") == std::string::npos)
        all[entry.path().string()] = content(entry.path());
    return all;
  }

 private:
  const TemporaryFolder folder_;
};

/// The processes that a process has started.
std::vector<pid_t> children_of(pid_t parent) {
  std::vector<pid_t> found;
  for (const auto& entry : fs::directory_iterator("/proc")) {
    if (std::atoi(entry.path().filename().c_str()) == 0) continue;
    std::ifstream file(entry.path() / "stat");
    std::string status;
    std::getline(file, status);  // nothing of a process that ends meanwhile
    const auto name_ends = status.rfind(')');
    if (name_ends == std::string::npos) continue;
    std::istringstream rest(status.substr(name_ends + 1));
    std::string state;
    pid_t its_parent = 0;
    if (rest >> state >> its_parent && its_parent == parent)
      found.push_back(std::atoi(entry.path().filename().c_str()));
  }
  return found;
}

TEST(SharedSweeps, EachWorkerTakesWhatNobodyHas) {
  const SharedSweep sweep(two_samples);
  const auto a = sweep.worker("out", 1), b = sweep.worker("out", 2);
  EXPECT_EQ(a->wait().code, spent_steps);
  EXPECT_EQ(b->wait().code, spent_steps);
  sweep.expect_each_done_once("out", 2);
  const auto taken = sweep.said("out", "taken");
  for (const auto& [sample, times] : taken) EXPECT_GE(times, 1) << sample;
}

TEST(SharedSweeps, AWorkerLeavesWhatOthersRun) {
  const SharedSweep sweep(std::string(two_samples) + "\"contact.friction\" = [0.3]\n");
  const auto a = sweep.worker("out", 1, {"--jobs", "2", "--takeover", "1m"});
  while (a->runs() && children_of(a->id()).size() < 2) std::this_thread::sleep_for(1ms);
  const Ending b = sweep.worker("out", 2, {"--leave"})->wait();
  EXPECT_EQ(b.code, 0);
  EXPECT_THAT(b.out, HasSubstr("run by other workers"));
  EXPECT_EQ(a->wait().code, spent_steps);
  sweep.expect_each_done_once("out", 2);
}

TEST(NightlySharedSweeps, ASpentWallTimeSavesAndTheNextGoesOn) {
  const SharedSweep sweep(two_samples);
  const std::vector<std::string> longer{"--set", "stop.steps=400_000"};
  ASSERT_EQ(sweep.worker("whole", 1, longer)->wait().code, spent_steps);
  std::vector<std::string> in_pieces = longer;
  in_pieces.insert(in_pieces.end(), {"--walltime", "4s"});
  int spent = 0;
  for (Ending end; end.code != spent_steps && spent < 100 && !testing::Test::HasFailure();) {
    end = sweep.worker("out", 1, in_pieces)->wait();
    EXPECT_TRUE(end.code == samples_left || end.code == spent_steps) << end.out;
    spent += end.code == samples_left;
  }
  EXPECT_GE(spent, 1);
  sweep.expect_each_done_once("out", 2);
  EXPECT_EQ(sweep.tables("out"), sweep.tables("whole"));
}

/// A process that was killed has a number until whoever inherited it has asked for its end.
bool still_runs(pid_t process) {
  std::ifstream file(fmt::format("/proc/{}/stat", process));
  std::string stat;
  return std::getline(file, stat) && stat.find(") Z ") == stat.npos;
}

/// Both a worker and what it runs are stopped for longer than the takeover time: another finishes its
/// samples; then they wake up and write on.
void expect_no_harm_of_a_stalled_worker(bool with_its_runs) {
  const SharedSweep sweep(two_samples);
  ASSERT_EQ(sweep.worker("whole", 1)->wait().code, spent_steps);
  const auto stalled = sweep.worker("out", 1, {"--jobs", "2"});
  const std::string point = sweep.path("out/samples/size_ratio=1.0,small_fraction=0.0,friction=0.3");
  while (stalled->runs() && !fs::exists(point + "/1.turn-1/run/b.checkpoint"))
    std::this_thread::sleep_for(1ms);
  const std::vector<pid_t> runs = children_of(stalled->id());
  EXPECT_EQ(runs.size(), 2u);
  std::vector<pid_t> stopped{stalled->id()};
  if (with_its_runs) stopped.insert(stopped.end(), runs.begin(), runs.end());
  for (const pid_t process : stopped) ::kill(process, SIGSTOP);
  EXPECT_EQ(sweep.worker("out", 2)->wait().code, spent_steps);
  const auto before = sweep.files("out");
  EXPECT_EQ(sweep.tables("out"), sweep.tables("whole"));
  for (const pid_t process : stopped) ::kill(process, SIGCONT);
  const Ending end = stalled->wait();
  EXPECT_EQ(end.code, spent_steps) << end.out;
  for (const pid_t run : runs) EXPECT_FALSE(still_runs(run)) << "what it had lost does not go on";
  EXPECT_EQ(sweep.files("out"), before);
  EXPECT_EQ(sweep.tables("out"), sweep.tables("whole"));
  sweep.expect_each_done_once("out", 2);
}

TEST(NightlySharedSweeps, AStalledMachineThatComesBackHarmsNothing) {
  expect_no_harm_of_a_stalled_worker(true);
}
TEST(NightlySharedSweeps, AStalledWorkerThatComesBackHarmsNothing) {
  expect_no_harm_of_a_stalled_worker(false);
}

/// What a round of kills has come to.
struct Round {
  int kills = 0;
  int turns = 0;
};

/// Four workers on four machines; two of them are killed now and then, and new ones come.
Round round_of_kills(const SharedSweep& sweep, const std::string& out, std::mt19937_64& random) {
  Round round;
  std::array<std::unique_ptr<Process>, 4> workers;
  int machine = 0;
  for (auto& worker : workers) worker = sweep.worker(out, ++machine);
  const auto ended = [&] {
    return std::any_of(workers.begin(), workers.end(), [](const auto& worker) { return !worker->runs(); });
  };
  while (!ended()) {
    const auto until = std::chrono::steady_clock::now() + 400ms + (random() % 1200) * 1ms;
    while (std::chrono::steady_clock::now() < until && !ended()) std::this_thread::sleep_for(5ms);
    if (ended()) break;
    const std::size_t first = random() % 4, second = (first + 1 + random() % 3) % 4;
    for (const std::size_t n : {first, second}) {
      workers[n]->signal(SIGKILL);
      round.kills += workers[n]->wait().signal == SIGKILL;
    }
    // No date of a file counts.
    for (const auto& entry : fs::directory_iterator(sweep.path(out) + "/workers")) {
      std::error_code gone;
      fs::last_write_time(entry, fs::file_time_type::clock::now() + std::chrono::hours(random() % 1000),
                          gone);
    }
    for (const std::size_t n : {first, second}) workers[n] = sweep.worker(out, ++machine);
  }
  for (auto& worker : workers) {
    const Ending ending = worker->wait();
    EXPECT_EQ(ending.code, 0) << ending.signal << ending.out;
  }
  for (const auto& [sample, times] : sweep.said(out, "taken")) round.turns += times;
  return round;
}

void expect_rounds_of_kills(int rounds, unsigned seed) {
  const SharedSweep sweep(forty_samples);
  ASSERT_EQ(sweep.worker("whole", 1)->wait().code, 0);
  const std::string whole = sweep.tables("whole");
  std::mt19937_64 random(seed);
  Round all;
  for (int n = 0; n < rounds && !testing::Test::HasFailure(); ++n) {
    const Round round = round_of_kills(sweep, "out", random);
    EXPECT_EQ(sweep.tables("out"), whole) << "round " << n;
    sweep.expect_each_done_once("out", 40);
    if (!testing::Test::HasFailure()) fs::remove_all(sweep.path("out"));
    all.kills += round.kills;
    all.turns += round.turns;
  }
  std::cout << rounds << " rounds, " << all.kills << " workers killed, " << all.turns << " turns for "
            << 40 * rounds << " samples\n";
}

TEST(ReliableSharedSweep, AWorkerThatIsKilledLosesNothing) {
  const SharedSweep sweep(two_samples);
  const auto killed = sweep.worker("out", 1, {"--jobs", "2"});
  const std::string point = sweep.path("out/samples/size_ratio=1.0,small_fraction=0.0,friction=0.3");
  while (killed->runs() && !fs::exists(point + "/1.turn-1/run/b.checkpoint"))
    std::this_thread::sleep_for(1ms);
  killed->signal(SIGKILL);
  killed->wait();
  EXPECT_EQ(sweep.worker("out", 2, {"--jobs", "2"})->wait().code, spent_steps);
  sweep.expect_each_done_once("out", 2);
  for (const SampleRow& row : read_sample_table(sweep.path("out")).rows) EXPECT_EQ(row.steps, 40'000);
}

TEST(NightlySharedSweep, AHundredRoundsOfKillsChangeNothing) { expect_rounds_of_kills(100, 1); }

}  // namespace
}  // namespace furnas
