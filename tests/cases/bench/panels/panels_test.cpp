#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "cases/program/bench/panels/collision_panel.h"
#include "cases/program/bench/panels/conservation_panel.h"
#include "cases/program/bench/panels/contact_panel.h"
#include "cases/program/bench/panels/error_panel.h"
#include "cases/program/bench/panels/groove_panel.h"
#include "cases/program/bench/panels/threads_panel.h"
#include "cases/program/bench/panels/trajectory_panel.h"
#include "tests/cases/runs.h"

namespace furnas {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr const char* right_law = "hooke_synchronized";

/// p in error ~ step^p, from two steps with the ratio `ratio`.
double order_of(double coarse, double fine, double ratio) {
  return std::log(std::abs(coarse / fine)) / std::log(ratio);
}

/// The first row that fits.
template <class Row, class Fits>
const Row& row_where(const std::vector<Row>& rows, Fits&& fits) {
  const auto found = std::find_if(rows.begin(), rows.end(), fits);
  if (found == rows.end()) throw std::runtime_error("no such row");
  return *found;
}

/// Second order where velocities are predicted, first where damping lags; sliding to 1 % at 50 steps.
TEST(BenchPanels, CollisionsConvergeToTheirClosedForms) {
  const auto errors = collision_errors(Effort::quick);
  const auto mean = [&](const std::string& law, const std::string& quantity, double steps) {
    return row_where(errors,
                     [&](const CollisionError& e) {
                       return e.law == law && e.precision == "double" && e.quantity == quantity &&
                              e.steps == steps;
                     })
        .mean;
  };
  EXPECT_GT(order_of(mean(right_law, "restitution", 25), mean(right_law, "restitution", 100), 4), 1.75);
  EXPECT_NEAR(order_of(mean(right_law, "slip stuck", 25), mean(right_law, "slip stuck", 100), 4), 2, 0.15);
  EXPECT_NEAR(
      order_of(mean("hooke_history", "restitution", 25), mean("hooke_history", "restitution", 100), 4), 1,
      0.1);
  for (const char* law : {right_law, "hooke_history"})
    for (const char* quantity : {"slip sliding", "spin sliding"})
      EXPECT_LT(std::abs(mean(law, quantity, 50)), 1e-2) << law << " " << quantity;
  for (const CollisionError& e : errors) EXPECT_GE(e.rms, 0.99 * std::abs(e.mean)) << e.quantity;
}

TEST(BenchPanels, EnduringContactsConvergeToTheirClosedForms) {
  const auto errors = contact_errors(Effort::quick);
  const auto at = [&](const std::string& law, double steps) {
    return row_where(errors, [&](const ContactError& e) { return e.law == law && e.steps == steps; });
  };
  EXPECT_GT(order_of(at(right_law, 50).frequency, at(right_law, 200).frequency, 4), 1.9);
  EXPECT_NEAR(order_of(at(right_law, 50).decay, at(right_law, 200).decay, 4), 2, 0.1);
  EXPECT_NEAR(order_of(at("hooke_history", 50).decay, at("hooke_history", 200).decay, 4), 1, 0.1);
  for (const ContactError& e : errors) EXPECT_LT(std::abs(e.shear), 1e-3) << e.law << " " << e.steps;
}

/// T17 and T18: the small sphere rolls out in time and is held up to the angle of friction; by the legacy law
/// it sticks where friction holds the wedge of the groove.
TEST(BenchPanels, GrooveAndWedgeAreRightForTheDefaultLawAlone) {
  for (const GrooveError& e : groove_errors(Effort::quick)) {
    EXPECT_LT(std::abs(e.wedge), 0.1) << e.law << " " << e.size_ratio << " " << e.step;
    if (e.law == right_law) {
      ASSERT_TRUE(e.late) << e.size_ratio << " " << e.step;
      EXPECT_LT(std::abs(*e.late), 0.02) << e.size_ratio << " " << e.step;
      EXPECT_LT(e.load, 1 + 1e-3);
    } else if (e.size_ratio == 10) {
      EXPECT_TRUE(!e.late || *e.late > 0.02) << e.step;
    }
  }
}

TEST(BenchPanels, WhatIsConservedIsMissedByTheOrderOfTheStep) {
  const auto errors = conservation_errors(Effort::quick);
  const auto at = [&](const std::string& quantity, const std::string& law, double step) {
    return row_where(errors,
                     [&](const ConservationError& e) {
                       return e.quantity == quantity && e.law == law && e.precision == "double" &&
                              e.step == step;
                     })
        .error;
  };
  EXPECT_LT(at("energy ledger", right_law, 0.02), 5e-3);
  EXPECT_LT(at("energy ledger", right_law, 0.02), at("energy ledger", "hooke_history", 0.02));
  EXPECT_LT(at("energy ledger", right_law, 0.01), 0.5 * at("energy ledger", right_law, 0.04));
  EXPECT_LT(at("momentum", right_law, 0.02), 1e-12) << "Newton's third law";
  EXPECT_LT(at("enthalpy", "frictionless", 0.01), 0.5 * at("enthalpy", "frictionless", 0.04));
  EXPECT_LT(at("enthalpy", "frictionless", 0.02), 1e-3);
}

TEST(BenchPanels, TrajectoriesPartSoonerWithLongerStepsAndNeverForThreads) {
  const auto errors = trajectory_errors(Effort::quick);
  const auto parted = [&](double step) {
    return row_where(errors,
                     [&](const TrajectoryError& e) {
                       return e.precision == "double" && e.threads == 1 && e.step == step;
                     })
        .parted;
  };
  EXPECT_GT(parted(0.02), parted(0.08));
  std::size_t threads = 0;
  for (const TrajectoryError& e : errors)
    if (e.threads > 1) {
      EXPECT_EQ(e.largest, 0) << e.precision;
      ++threads;
    }
  EXPECT_EQ(threads, 2u);
}

TEST(BenchPanels, ThreadsHaveTheSameBits) {
  const auto rows = thread_rows(Effort::quick);
  ASSERT_GE(rows.size(), 2u);
  for (const ThreadsRow& row : rows) {
    EXPECT_EQ(row.hash, rows.front().hash) << row.threads;
    EXPECT_GT(row.rate.low, 0);
  }
  EXPECT_EQ(rows.front().speed_up.median, 1);
}

TEST(BenchPanels, ForcesAreThoseOfLongDouble) {
  const Runs runs;
  const Answer answer = furnas(
      {"bench", "error", test_data("a3.data"), "--precision", "double,mixed", "--out", runs.path("error")});
  ASSERT_EQ(answer.code, ExitCode::done) << answer.err;
  EXPECT_TRUE(fs::exists(runs.path("error/error.svg")));
  const PanelResult result = panel_of(std::vector<ForceErrorRow>{
      {"a", 5, 0.3, "double", {9, 0, 0, 1e-15, 1e-14}}, {"a", 5, 0.3, "mixed", {9, 0, 0, 1e-8, 1e-7}}});
  ASSERT_EQ(result.chart.series.size(), 4u) << "median and worst in two precisions";
  EXPECT_EQ(result.chart.series[3].y.front(), 1e-7);
  EXPECT_EQ(result.chart.notes.size(), 1u) << "the packing is named once";
}

TEST(BenchPanels, EachIsACommandThatLeavesATableAndAChart) {
  const Runs runs;
  for (const char* name : {"contact", "conservation"}) {
    const Answer answer = furnas({"bench", name, "--quick", "--out", runs.path("panels")});
    ASSERT_EQ(answer.code, ExitCode::done) << answer.err;
    for (const char* extension : {".csv", ".svg", ".png"})
      EXPECT_TRUE(fs::exists(runs.path("panels/" + std::string(name) + extension))) << name << extension;
  }
  EXPECT_THAT(content(runs.path("panels/contact.csv")), HasSubstr("hooke_synchronized,100,"));
  for (const Panel& panel : panels())
    EXPECT_THAT(furnas({"bench", panel.name, "--help"}).out, HasSubstr("--quick")) << panel.name;
}

}  // namespace
}  // namespace furnas
