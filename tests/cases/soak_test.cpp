#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

#include "cases/program/run/recording.h"
#include "engine/start/mixture.h"
#include "tests/cases/process.h"
#include "tests/cases/runs.h"

namespace furnas {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;
using Minutes = std::chrono::duration<double, std::ratio<60>>;

constexpr double checkpoint_seconds = 6;

/// A cell so heavy that it is sheared for ever at the rate it begins with, so that it is flipped again and
/// again.
constexpr const char* sheared_case = R"([start]
file = "sheared.checkpoint"
[compaction]
inertia_absolute = 1e25
pressure = 1e-3
[stop]
steps = 1_000_000_000_000
kinetic_energy = 1e-30
[compute]
threads = 1
[output]
history_every = 1000
snapshot_every = 50_000
checkpoint_minutes = 0.1
picture = "none"
)";

Packing sheared_gas() {
  Packing p =
      dilute_start({.size_ratio = 2, .small_fraction = 0.4, .large = 100, .start_fraction = 0.3, .seed = 1});
  const double denser = std::cbrt(0.3 / 0.45);
  Triangle& h = p.cell.edges;
  h.xx *= denser, h.yy *= denser, h.zz *= denser;
  p.cell.rate.xy = 2e-3;
  return p;
}

/// What is seen of the process from outside.
struct SoakSample {
  double memory{};      ///< resident [bytes]
  double processor{};   ///< time it has used [s]
  double step{};        ///< of the last row of its history
  double checkpoint{};  ///< age of the newest checkpoint [s]
};

double last_step(const fs::path& history) {
  std::ifstream in(history);
  in.seekg(-4000, std::ios::end);
  std::string text{std::istreambuf_iterator<char>(in), {}};
  text.resize(text.rfind('\n'));
  return std::atof(text.substr(text.rfind('\n') + 1).c_str());
}

SoakSample sample_of(pid_t process, const fs::path& run) {
  SoakSample s;
  const std::string proc = "/proc/" + std::to_string(process);
  double pages = 0;
  std::ifstream(proc + "/statm") >> pages >> pages;
  s.memory = pages * static_cast<double>(::sysconf(_SC_PAGE_SIZE));
  const std::string stat = content(proc + "/stat");
  std::istringstream fields(stat.substr(stat.rfind(')') + 2));
  std::string word;
  for (int k = 0; k < 11; ++k) fields >> word;
  double user = 0, system = 0;
  fields >> user >> system;
  s.processor = (user + system) / static_cast<double>(::sysconf(_SC_CLK_TCK));
  s.step = last_step(run / "history.csv");
  const auto newest =
      std::max(fs::last_write_time(run / "a.checkpoint"), fs::last_write_time(run / "b.checkpoint"));
  s.checkpoint = std::chrono::duration<double>(fs::file_time_type::clock::now() - newest).count();
  return s;
}

double cost_of_a_step(const SoakSample& a, const SoakSample& b) {
  return (b.processor - a.processor) / (b.step - a.step);
}

/// Half an hour, or FURNAS_SOAK_MINUTES, of all that a run can do: nothing may grow, and nothing fall behind.
TEST(NightlySoak, NothingGrowsAndNothingFallsBehind) {
  const char* asked = std::getenv("FURNAS_SOAK_MINUTES");
  const Minutes length(asked ? std::atof(asked) : 30.0);
  const Runs runs(sheared_case);
  write_checkpoint({sheared_gas(), "", {}}, runs.path("sheared.checkpoint"));
  const fs::path run = runs.path("run");
  Process process({"run", runs.path("case.toml"), "--out", run.string()});
  const auto begin = Clock::now();
  std::vector<SoakSample> samples;
  while (Clock::now() - begin < length && process.runs()) {
    std::this_thread::sleep_for(length / 200);
    if (fs::exists(run / "b.checkpoint")) samples.push_back(sample_of(process.id(), run));
  }
  ASSERT_TRUE(process.runs()) << process.wait().out;
  process.signal(SIGTERM);
  const Ending ending = process.wait();
  ASSERT_EQ(ending.code, 130) << ending.out;
  ASSERT_GE(samples.size(), 40u);

  const std::size_t quarter = samples.size() / 4;
  const auto most = [&](std::size_t first, std::size_t last, double SoakSample::*field) {
    double value = 0;
    for (std::size_t k = first; k < last; ++k) value = std::max(value, samples[k].*field);
    return value;
  };
  const double memory_then = most(quarter, 2 * quarter, &SoakSample::memory);
  const double memory_now = most(3 * quarter, samples.size(), &SoakSample::memory);
  const double cost_then = cost_of_a_step(samples[quarter], samples[2 * quarter]);
  const double cost_now = cost_of_a_step(samples[3 * quarter], samples.back());
  const double oldest = most(0, samples.size(), &SoakSample::checkpoint);
  const auto result = runs.result("run");
  std::cout << "minutes " << length.count() << ", steps " << result["steps"] << ", flips " << result["flips"]
            << ", lists " << result["lists_built"] << ", frames " << read_frames(run / "frames.pvd").size()
            << ", memory " << memory_then / 1e6 << " then " << memory_now / 1e6 << " MB, microseconds a step "
            << cost_then * 1e6 << " then " << cost_now * 1e6 << ", oldest checkpoint " << oldest << " s\n";
  EXPECT_LT(memory_now, 1.02 * memory_then + 1e6);
  EXPECT_LT(cost_now, 1.2 * cost_then);
  EXPECT_LT(oldest, 2 * checkpoint_seconds);
  EXPECT_GT(result["flips"], 5);
  EXPECT_GT(result["lists_built"], 100);
  const std::string more = std::to_string(result["steps"].get<std::int64_t>() + 1000);
  EXPECT_EQ(runs.resume("run", {"--steps", more}).code, ExitCode::budget_spent);
}

}  // namespace
}  // namespace furnas
