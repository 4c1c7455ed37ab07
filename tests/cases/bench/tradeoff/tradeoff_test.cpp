#include "cases/program/bench/tradeoff/tradeoff.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <thread>

#include "io/csv.h"
#include "tests/cases/process.h"
#include "tests/io/packings.h"

namespace furnas {
namespace {

using testing::HasSubstr;

const std::string smoke_tradeoff = std::string(FURNAS_SOURCE_DIR) + "/cases/tradeoff_smoke.toml";

/// The cells of each row of a tradeoff, under "case/arm" and their names.
std::map<std::string, std::map<std::string, std::string>> rows_of_tradeoff(const std::string& folder) {
  std::ifstream file(folder + "/tradeoff.csv");
  std::vector<std::string> names, cells;
  read_csv_row(file, names, "tradeoff.csv");
  std::map<std::string, std::map<std::string, std::string>> rows;
  while (read_csv_row(file, cells, "tradeoff.csv"))
    for (std::size_t k = 0; k < names.size(); ++k) rows[cells[0] + "/" + cells[1]][names[k]] = cells[k];
  return rows;
}

Ending tradeoff_into(const std::string& folder, const std::vector<std::string>& more = {}) {
  std::vector<std::string> words{"bench", "tradeoff", smoke_tradeoff, "--out", folder, "--jobs", "2"};
  words.insert(words.end(), more.begin(), more.end());
  return ending_of(words);
}

TEST(TradeoffCommand, TellsWhatEachArmCostsAndIsWorth) {
  const TemporaryFolder folder;
  const std::string out = (folder / "out").string();
  const Ending first = tradeoff_into(out);
  ASSERT_EQ(first.code, 0) << first.out;
  auto rows = rows_of_tradeoff(out);
  EXPECT_EQ(rows.size(), 4u + 1 + 6 + 1) << "arms, and the pressures extrapolated";
  EXPECT_EQ(rows["friction/default"]["standing"], "reference");
  EXPECT_EQ(rows["frictionless/default"]["n"], "3");
  EXPECT_EQ(rows["friction/default"]["n"], "4");
  EXPECT_EQ(rows["friction/out_of_steps"]["standing"], "failed");
  EXPECT_EQ(rows["friction/out_of_steps"]["budget"], "4");
  EXPECT_EQ(rows["friction/pressure_5e-2"]["standing"], "different") << "spheres so soft are pressed closer";
  EXPECT_GT(std::stod(rows["friction/pressure_5e-2"]["difference"]), 0);
  EXPECT_GT(std::stod(rows["frictionless/default"]["core_seconds"]), 0);
  EXPECT_GT(std::stod(rows["frictionless/default"]["evaluations"]), 0) << "of the minimizer";
  EXPECT_EQ(rows["frictionless/pressure_to_0"]["n"], "6");
  for (const char* file : {"friction.svg", "friction.png", "frictionless.svg", "samples.csv"})
    EXPECT_TRUE(std::filesystem::exists(out + "/" + file)) << file;

  // What is there is not run again, and says the same.
  const std::string before = content(out + "/tradeoff.csv");
  const Ending again = tradeoff_into(out);
  EXPECT_THAT(again.out, HasSubstr("36 samples, 36 of them finished and not run again"));
  EXPECT_EQ(content(out + "/tradeoff.csv"), before);
  const Ending more = tradeoff_into(out, {"--samples", "6", "--report"});
  ASSERT_EQ(more.code, 0) << more.out;
  EXPECT_EQ(rows_of_tradeoff(out)["friction/default"]["unfinished"], "2") << "a report runs nothing";
  ASSERT_EQ(tradeoff_into(out, {"--cases", "friction", "--arms", "paper", "--report"}).code, 0);
  EXPECT_EQ(rows_of_tradeoff(out).size(), 2u) << "the arm and its reference";
  EXPECT_THAT(tradeoff_into(out, {"--arms", "papper"}).out,
              HasSubstr("--arms papper: there is no such name"));
}

// Stopped by a signal and told again, it ends with the states of one that nobody touched.
TEST(ReliableTradeoff, GoesOnWhereItWasStopped) {
  const TemporaryFolder folder;
  const std::string whole = (folder / "whole").string(), broken = (folder / "broken").string();
  const std::vector<std::string> few{"--cases", "friction", "--arms", "time_step_0.02,out_of_steps"};
  ASSERT_EQ(tradeoff_into(whole, few).code, 0);
  std::vector<std::string> words{"bench", "tradeoff", smoke_tradeoff, "--out", broken, "--jobs", "2"};
  words.insert(words.end(), few.begin(), few.end());
  Process stopped(words);
  while (!std::filesystem::exists(broken + "/samples/friction") && stopped.runs())
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  stopped.signal(SIGTERM);
  stopped.wait();
  ASSERT_EQ(tradeoff_into(broken, few).code, 0);
  for (const char* sample : {"friction/default/1", "friction/time_step_0.02/3", "friction/out_of_steps/2"}) {
    const auto hash = [&](const std::string& out) {
      return nlohmann::json::parse(content(out + "/samples/" + sample + "/result.json"))["state_hash"];
    };
    EXPECT_EQ(hash(broken), hash(whole)) << sample;
  }
}

}  // namespace
}  // namespace furnas
