#include "cases/program/bench/tradeoff/comparison.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "cases/program/bench/tradeoff/work_precision.h"

namespace furnas {
namespace {

constexpr double no_density = std::numeric_limits<double>::quiet_NaN();

SampleRow made_sample(const std::string& arm, double phi, double seconds,
                      const std::string& verdict = "jammed") {
  SampleRow row;
  row.values = {"c", arm};
  row.verdict = verdict;
  row.phi = phi;
  row.phi_J = row.jammed() ? phi : no_density;
  row.Z = row.Z_backbone = row.backbone = no_density;
  row.cpu_seconds = seconds;
  row.wall_seconds = 2 * seconds;
  row.steps = 1000;
  row.evaluations = 10;
  return row;
}

TradeoffFile made_file(const std::vector<std::string>& arms) {
  TradeoffCase c{"c", arms.front(), 4, 0.01, {}};
  for (const std::string& arm : arms) {
    TradeoffArm a{arm, {}, arm.starts_with("pressure_")};
    if (a.pressure_alone) a.c.compaction.pressure = {std::stod(arm.substr(9))};
    c.arms.push_back(a);
  }
  return {{c}};
}

MeanInterval interval_of(double low, double high) { return {8, (low + high) / 2, 1, (high - low) / 2}; }

TEST(Tradeoff, StandingIsReadOffTheInterval) {
  EXPECT_EQ(standing_of(interval_of(-0.009, 0.0099), 0.01), Standing::equivalent);
  EXPECT_EQ(standing_of(interval_of(0.001, 0.009), 0.01), Standing::equivalent) << "different, but by little";
  EXPECT_EQ(standing_of(interval_of(0.001, 0.011), 0.01), Standing::different);
  EXPECT_EQ(standing_of(interval_of(-0.03, -0.001), 0.01), Standing::different);
  EXPECT_EQ(standing_of(interval_of(-0.001, 0.011), 0.01), Standing::undecided);
  EXPECT_EQ(standing_of({1, 0.5, 0, std::numeric_limits<double>::infinity()}, 0.01), Standing::undecided);
}

// With the samples that are named the interval decides: equivalent for a small difference, different for a
// large.
TEST(Tradeoff, SamplesToDecideDo) {
  for (const double d : {0.0, 0.002, 0.004, 0.006, 0.009, 0.021}) {
    constexpr double a = 0.03, b = 0.02, margin = 0.01;
    const auto n = static_cast<double>(samples_to_decide(a, b, d, margin));
    MeanInterval difference{0, d, 0, 2 * std::sqrt((a * a + b * b) / n)};
    EXPECT_NE(standing_of(difference, margin), Standing::undecided) << d;
    difference.half_width *= std::sqrt(n / (0.97 * n - 1));
    EXPECT_EQ(standing_of(difference, margin), Standing::undecided) << d;
  }
}

TEST(Tradeoff, ComparesEachArmWithTheReference) {
  SampleTable table{{"case", "arm"}, {}};
  for (const double noise : {-1e-3, 0.0, 1e-3, 2e-3}) {
    table.rows.push_back(made_sample("best", 0.6 + noise, 8));
    table.rows.push_back(made_sample("same", 0.6005 + noise, 4));
    table.rows.push_back(made_sample("loose", 0.58 + noise, 1));
    table.rows.push_back(made_sample("wild", 0.6 + 20 * noise, 2));
    table.rows.push_back(made_sample("lost", no_density, 3, "budget"));
  }
  table.rows.push_back(made_sample("same", no_density, 5, "diverged"));
  table.rows.push_back(made_sample("later", no_density, 0, "unfinished"));
  const auto all = compare(made_file({"best", "same", "loose", "wild", "lost", "later"}), table);
  ASSERT_EQ(all.size(), 1u);
  const auto& arms = all[0].arms;
  ASSERT_EQ(arms.size(), 6u);
  EXPECT_EQ(arms[5].standing, Standing::unfinished);
  EXPECT_EQ(arms[0].standing, Standing::reference);
  EXPECT_EQ(arms[1].standing, Standing::equivalent);
  EXPECT_EQ(arms[2].standing, Standing::different);
  EXPECT_EQ(arms[3].standing, Standing::undecided);
  EXPECT_EQ(arms[4].standing, Standing::failed);
  EXPECT_NEAR(arms[1].difference->mean, 5e-4, 1e-12);
  EXPECT_NEAR(arms[2].difference->mean, -0.02, 1e-12);
  EXPECT_EQ(arms[1].phi->samples, 4u);
  EXPECT_EQ(arms[1].lost(), 1u);
  EXPECT_EQ(arms[1].core_seconds->median, 4) << "the diverged one took its time, too";
  EXPECT_EQ(arms[1].wall_seconds->high, 10);
  ASSERT_TRUE(arms[3].to_decide);
  EXPECT_EQ(*arms[3].to_decide, samples_to_decide(arms[3].phi->deviation, arms[0].phi->deviation,
                                                  arms[3].difference->mean, 0.01));
  EXPECT_EQ(arms[4].budget, 4u);
  EXPECT_FALSE(arms[4].difference);
}

// phi = 0.6 + 2 p_a, exactly and with noise: the line says 0.6 at p_a = 0.
TEST(Tradeoff, ExtrapolatesThePressures) {
  SampleTable table{{"case", "arm"}, {}};
  std::mt19937_64 random(4);
  std::normal_distribution<double> noise(0, 1e-4);
  const std::vector<std::string> names{"best", "pressure_1e-2", "pressure_5e-3", "pressure_1e-3"};
  for (const std::string& name : names)
    for (int n = 0; n < 4; ++n) {
      const double p = name == "best" ? 0 : std::stod(name.substr(9));
      table.rows.push_back(made_sample(name, 0.6 + 2 * p + noise(random), 1));
    }
  const auto arms = compare(made_file(names), table)[0].arms;
  ASSERT_EQ(arms.size(), 5u);
  const ComparedArm& zero = arms.back();
  EXPECT_EQ(zero.arm, extrapolated_arm);
  EXPECT_EQ(zero.phi->samples, 12u);
  EXPECT_NEAR(zero.phi->mean, 0.6, 2e-4);
  EXPECT_LT(zero.phi->half_width, 3e-4);
  EXPECT_EQ(zero.standing, Standing::equivalent);
  EXPECT_EQ(zero.core_seconds->median, 3);
  EXPECT_EQ(arms[1].standing, Standing::different) << "2 p_a = 0.02";
}

TEST(Tradeoff, ChartHasAPointAndAWordForEachArm) {
  SampleTable table{{"case", "arm"}, {}};
  for (const double noise : {-1e-3, 1e-3}) {
    table.rows.push_back(made_sample("best", 0.6 + noise, 8));
    table.rows.push_back(made_sample("loose_one", 0.5 + noise, 1));
    table.rows.push_back(made_sample("lost", no_density, 3, "budget"));
  }
  const Chart chart = work_precision_chart(compare(made_file({"best", "loose_one", "lost"}), table)[0]);
  ASSERT_EQ(chart.notes.size(), 3u);
  EXPECT_EQ(chart.notes[1].text, "loose one");
  EXPECT_EQ(chart.notes[2].text, "lost (budget 2 of 2)");
  EXPECT_NEAR(chart.notes[1].y, 0.1, 1e-12);
  EXPECT_EQ(chart.notes[1].x, 1);
  EXPECT_TRUE(work_precision_chart(compare(made_file({"best"}), {{"case", "arm"}, {}})[0]).series.empty());
}

}  // namespace
}  // namespace furnas
