#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cases/program/bench/packings.h"
#include "cases/program/bench/speed.h"
#include "io/lammps_data.h"
#include "tests/cases/runs.h"

namespace furnas {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;

/// Changes that make a case of cases/bench/ end within a second, loosely jammed.
const std::vector<std::string> in_haste = {"--set", "mixture.large=60",
                                           "--set", "compaction.pressure=1e-3",
                                           "--set", "stop.stress_error=0.1",
                                           "--set", "stop.force_imbalance=1e-1",
                                           "--set", "stop.kinetic_energy=1e-5",
                                           "--set", "stop.strain_drift=1e-1",
                                           "--set", "stop.window=4",
                                           "--set", "stop.steps=50000"};

Answer prepare(const std::string& folder, std::vector<std::string> more = {}) {
  std::vector<std::string> arguments{"bench", "prepare", "--out", folder, "--ratios", "1"};
  arguments.insert(arguments.end(), in_haste.begin(), in_haste.end());
  arguments.insert(arguments.end(), more.begin(), more.end());
  return furnas(arguments);
}

TEST(BenchPackings, ComeCloseToTheSizeAskedFor) {
  EXPECT_EQ(times_for(1000, 1000), (Times{1, 1, 1}));
  EXPECT_EQ(times_for(1000, 8000), (Times{2, 2, 2}));
  EXPECT_EQ(times_for(1000, 1e6), (Times{10, 10, 10}));
  EXPECT_EQ(times_for(27430, 1000), (Times{1, 1, 1}));
  EXPECT_EQ(times_for(1000, 1900), (Times{2, 1, 1}));
}

TEST(BenchPackings, HaveACaseForEachRatio) {
  EXPECT_THAT(benchmark_ratios(), ElementsAre(1, 2, 5, 10, 20, 40));
}

TEST(Bench, PreparesOnceAndMeasures) {
  const Runs runs;
  const Answer first = prepare(runs.path("packings"), {"--sizes", "500"});
  ASSERT_EQ(first.code, ExitCode::done) << first.err << first.out;
  EXPECT_THAT(first.out, HasSubstr("alpha_1: begins"));
  EXPECT_TRUE(fs::exists(runs.path("packings/alpha_1_480.checkpoint")));
  const Answer again = prepare(runs.path("packings"), {"--sizes", "500"});
  EXPECT_THAT(again.out, HasSubstr("alpha_1: finished already"));
  EXPECT_THAT(again.out, HasSubstr("alpha_1_480.checkpoint: there already"));

  const Answer speed = furnas({"bench",       "speed",
                               "--packings",  runs.path("packings"),
                               "--ratios",    "1",
                               "--sizes",     "60,480,10",
                               "--friction",  "0,0.3",
                               "--threads",   "1,2",
                               "--precision", "double,mixed",
                               "--steps",     "20",
                               "--repeats",   "2",
                               "--triad",     "1",
                               "--csv",       runs.path("speed.csv")});
  ASSERT_EQ(speed.code, ExitCode::done) << speed.err;
  EXPECT_THAT(speed.out, HasSubstr("contact forces"));
  EXPECT_THAT(speed.err, HasSubstr("no packing of 10 particles"));
  const std::string csv = content(runs.path("speed.csv"));
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 2 * 2 * 2 * 2);
  EXPECT_THAT(csv, HasSubstr("\nalpha_1,480,0.3,double,2,20,"));

  const Answer error = furnas({"bench", "error", runs.path("packings/alpha_1_480.checkpoint")});
  ASSERT_EQ(error.code, ExitCode::done) << error.err;
  EXPECT_THAT(error.out, HasSubstr("alpha_1_480  480  0.3      mixed"));
}

TEST(Bench, SpeedIsThatOfTheSameMotionForEveryThread) {
  const Packing packing = read_lammps_data(test_data("a3.data"));
  SpeedOrder order;
  order.variants = {{"double", 1}, {"double", 2}, {"double", 3}};
  order.repeats = 2;
  order.steps = 5;
  const auto rows = measure_speed("gas", packing, order);
  ASSERT_EQ(rows.size(), 3U);
  for (const SpeedRow& row : rows) {
    EXPECT_EQ(row.hash, rows[0].hash);
    EXPECT_GT(row.rate.low, 0);
    EXPECT_GE(row.rate.high, row.rate.median);
    double sum = 0;
    for (const auto& [title, share] : row.shares) sum += share;
    EXPECT_NEAR(sum, 1, 1e-9);
  }
}

TEST(Bench, SaysWhatIsWrong) {
  const Runs runs;
  struct Wrong {
    std::vector<std::string> arguments;
    const char* says;
  };
  const Wrong table[] = {
      {{"bench"}, "subcommand"},
      {{"bench", "prepare", "--ratios", "3", "--out", runs.path("x")}, "--ratios 3: there is no case for it"},
      {{"bench", "speed", "--packings", runs.path("x")}, "furnas bench prepare"},
      {{"bench", "error", test_data("a3.data"), "--precision", "half"}, "compute.precision"},
      {{"bench", "error", test_data("a3.data"), "--law", "none"}, "contact.law"},
  };
  for (const Wrong& wrong : table) {
    const Answer answer = furnas(wrong.arguments);
    EXPECT_EQ(answer.code, ExitCode::bad_case) << wrong.says;
    EXPECT_THAT(answer.err, HasSubstr(wrong.says));
  }
}

}  // namespace
}  // namespace furnas
