#include "cases/program/sweep/pool.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <nlohmann/json.hpp>
#include <thread>

#include "cases/program/sweep/sample_table.h"
#include "tests/cases/process.h"
#include "tests/io/packings.h"

namespace furnas {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// Two samples, the second of which would go on for minutes.
constexpr const char* unequal = R"([mixture]
large = 50
start_fraction = 0.25
[stop]
kinetic_energy = 1e-30
[output]
picture = "none"
[sweep]
"stop.steps" = [20_000, 100_000_000]
)";

class Pools : public testing::Test {
 protected:
  Pools() { write_file(folder_ / "a.toml", unequal); }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  std::vector<std::string> command() const {
    return {"sweep", path("a.toml"), "--out", path("out"), "--jobs", "2"};
  }
  /// Waits for a file of the long sample while it runs.
  bool appears(const std::string& name) const {
    for (int n = 0; n < 12'000; ++n) {
      if (fs::exists(long_sample().string() + ".turn-1/run/" + name)) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return false;
  }
  fs::path long_sample() const {
    return path("out/samples/size_ratio=1.0,small_fraction=0.0,friction=0.3,steps=100000000/1");
  }

 private:
  TemporaryFolder folder_;
};

TEST_F(Pools, WhatGoesWrongBetweenSamplesLosesNone) {
  // Of the shorter samples the longer one runs first, for seconds: nothing ends before the folder is made.
  std::string several = unequal;
  several.replace(several.find("20_000"), 6, "200_000, 800_000");
  write_file(path("a.toml"), several);
  Process process(command());
  ASSERT_TRUE(appears("a.checkpoint"));
  // The table that is due when a shorter sample ends cannot be written.
  fs::remove(path("out/points.csv"));
  fs::create_directory(path("out/points.csv"));
  const Ending end = process.wait();
  EXPECT_EQ(end.code, 7) << end.out;
  EXPECT_THAT(end.out, HasSubstr("points.csv"));
  EXPECT_EQ(nlohmann::json::parse(content(long_sample() / "result.json"))["verdict"], "interrupted");
}

TEST_F(Pools, ASampleStoppedWhileItStartsHasNotFailed) {
  Process process(command());
  while (process.runs() && !fs::exists(path("out/sweep.csv")))
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  process.signal(SIGTERM);
  ASSERT_EQ(process.wait().code, 130);
  for (const SampleRow& row : read_sample_table(path("out")).rows) EXPECT_EQ(row.verdict, "unfinished");
}

}  // namespace
}  // namespace furnas
