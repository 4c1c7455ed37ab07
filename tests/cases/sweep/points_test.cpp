#include "cases/program/sweep/points.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "cases/program/sweep/refinement.h"
#include "engine/base/require.h"
#include "engine/statistics/furnas_model.h"
#include "tests/cases/sweep/made_rows.h"
#include "tests/io/packings.h"

namespace furnas {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(SampleTable, ReadsWhatItWrites) {
  const TemporaryFolder folder;
  SampleTable table = paper_table();
  table.rows = {jammed_row("5.0", "0.3", "0.1", 7, 0.7), spent_row("5.0", "0.3", "0.1", 8)};
  SampleRow failed = spent_row("5.0", "0.3", "0.1", 9);
  failed.verdict = "failed";
  failed.phi = failed.Z = failed.Z_backbone = failed.backbone = std::nan("");
  table.rows.push_back(failed);
  write_file(folder / sample_table_name, csv(table));
  const SampleTable read = read_sample_table(folder / "");
  EXPECT_EQ(read.keys, table.keys);
  ASSERT_EQ(read.rows.size(), 3u);
  EXPECT_EQ(csv(read), csv(table));
  EXPECT_EQ(read.rows[0].size_ratio, 5);
  EXPECT_EQ(read.rows[0].small_fraction, 0.3);
  EXPECT_EQ(read.rows[0].friction, 0.1);
  EXPECT_EQ(read.rows[0].phi_J, 0.7);
  EXPECT_TRUE(std::isnan(read.rows[1].phi_J));
  EXPECT_EQ(read.rows[1].reason, "all steps are spent; it waits");
}

/// A spreadsheet may have quoted them, commas included.
TEST(SampleTable, ReadsQuotedCells) {
  const TemporaryFolder folder;
  SampleTable table = paper_table();
  table.rows = {spent_row("5.0", "0.3", "0.1", 8)};
  std::string text = csv(table);
  const std::string reason = "all steps are spent; it waits";
  text.replace(text.find(reason), reason.size(), "\"all steps are spent, it waits\"");
  write_file(folder / sample_table_name, text);
  EXPECT_EQ(read_sample_table(folder / "").rows.at(0).reason, "all steps are spent, it waits");
}

/// The tables in docs/results/study, byte for byte.
TEST(SampleTable, ReadsAndWritesThoseOfTheStudy) {
  for (const char* name : {"mono", "alpha_5", "alpha_20", "version_0.2.0/alpha_5", "version_0.2.0/alpha_20",
                           "version_0.2.0/mono"}) {
    const std::filesystem::path folder =
        std::filesystem::path(FURNAS_SOURCE_DIR) / "docs/results/study" / name;
    const SampleTable table = read_sample_table(folder);
    EXPECT_EQ(csv(table), content(folder / sample_table_name)) << name;
    EXPECT_EQ(csv(points_of(table), table.keys), content(folder / "points.csv")) << name;
  }
}

// The first versions knew neither bounds nor the thickness of cells.
TEST(SampleTable, ReadsAnyNumberOfTheNewerColumns) {
  SampleTable table = paper_table();
  table.rows = {jammed_row("5.0", "0.3", "0.1", 7, 0.7)};
  table.rows[0].thickness = 4.5;
  table.rows[0].pressure = 1e-3;
  table.rows[0].preset = "fast";
  const std::string text = csv(table);
  for (int fewer = 0; fewer <= 4; ++fewer) {
    std::string older;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line); older += line + "\n")
      for (int k = 0; k < fewer; ++k) line.resize(line.rfind(','));
    const TemporaryFolder folder;
    write_file(folder / sample_table_name, older);
    const SampleRow row = read_sample_table(folder / "").rows.at(0);
    EXPECT_EQ(row.phi_J, 0.7);
    EXPECT_EQ(row.preset, fewer > 0 ? "" : "fast");
    EXPECT_EQ(std::isfinite(row.pressure), fewer < 2);
    EXPECT_EQ(std::isfinite(row.thickness), fewer < 3);
  }
  const TemporaryFolder folder;
  write_file(folder / sample_table_name, text.substr(0, text.find(",phi,")) + "\n");
  EXPECT_THROW(read_sample_table(folder / ""), InputError) << "far too few";
}

TEST(Points, AreTooThinBelowTwoAndAHalfDiameters) {
  SampleTable table = paper_table();
  table.rows = {jammed_row("5.0", "0.3", "0.1", 1, 0.7), jammed_row("5.0", "0.3", "0.1", 2, 0.7)};
  for (SampleRow& row : table.rows) row.thickness = 2.7;
  EXPECT_FALSE(points_of(table)[0].too_thin());
  table.rows[1].thickness = 2.4;
  EXPECT_TRUE(points_of(table)[0].too_thin()) << "the thinnest counts";
  EXPECT_EQ(thickness_text(points_of(table)[0]), "2.4");
  table.rows[1] = spent_row("5.0", "0.3", "0.1", 2);
  table.rows[1].thickness = 1;
  EXPECT_FALSE(points_of(table)[0].too_thin()) << "only those that count in the mean";
}

TEST(Points, OfUnknownThicknessAreAtMostThoseOfACube) {
  SampleTable table = paper_table();
  table.rows = {jammed_row("20.0", "0.3", "0.1", 1, 0.8)};
  table.rows[0].large = 10;
  table.rows[0].small = 32'676;
  // (pi/6 (80000 + 32676)/0.8)^(1/3)/20
  EXPECT_NEAR(points_of(table)[0].thickness_at_most, 2.097, 1e-3);
  EXPECT_TRUE(points_of(table)[0].too_thin());
  EXPECT_EQ(thickness_text(points_of(table)[0]), "at most 2.1");
}

TEST(SampleTable, RefusesWhatIsNone) {
  const TemporaryFolder folder;
  EXPECT_THROW(read_sample_table(folder / ""), InputError);
  for (const char* text : {"", "a,b\n1,2\n"}) {
    write_file(folder / sample_table_name, text);
    EXPECT_THROW(read_sample_table(folder / ""), InputError) << text;
  }
  SampleTable table = paper_table();
  table.rows = {jammed_row("5.0", "0.3", "0.1", 7, 0.7)};
  std::string text = csv(table);
  write_file(folder / sample_table_name, text + "1,2,3\n");
  EXPECT_THROW(read_sample_table(folder / ""), InputError);
  text.replace(text.find("1.5"), 3, "one");
  write_file(folder / sample_table_name, text);
  try {
    read_sample_table(folder / "");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("sweep.csv:2: \"one\""));
  }
}

TEST(Points, AreMeansOfTheJammed) {
  SampleTable table = paper_table();
  table.rows = {jammed_row("5.0", "0.3", "0.1", 1, 0.7), jammed_row("5.0", "0.3", "0.1", 2, 0.72),
                spent_row("5.0", "0.3", "0.1", 3), jammed_row("1.0", "0.0", "0.1", 1, 0.6)};
  const auto points = points_of(table);
  ASSERT_EQ(points.size(), 2u);
  const Point& p = points[0];
  EXPECT_EQ(p.samples, 3u);
  EXPECT_EQ(p.jammed, 2u);
  EXPECT_EQ(p.budget, 1u);
  EXPECT_DOUBLE_EQ(p.mean_phi_J->mean, 0.71);
  EXPECT_NEAR(p.mean_phi_J->half_width, 12.7062 * 0.01, 1e-5);  // Student's t of two samples
  EXPECT_DOUBLE_EQ(p.effective_size, 180);
  EXPECT_DOUBLE_EQ(p.small_rattlers[1]->mean, 0.2);
  EXPECT_DOUBLE_EQ(p.large_rattlers[2]->mean, 0.03);
  EXPECT_FALSE(points[1].small_rattlers[1]) << "there are no small spheres";
  const std::string text = csv(points, table.keys);
  EXPECT_THAT(text, HasSubstr("5.0,0.3,0.1,100,1000,3,2,0,0.667,1,0,0,0,180,0.71,"));
}

TEST(Points, SettledSamplesWidenTheIntervalByTheirBounds) {
  SampleTable table = paper_table();
  table.rows = {jammed_row("5.0", "0.3", "0.1", 1, 0.7), spent_row("5.0", "0.3", "0.1", 2)};
  SampleRow& settled = table.rows[1];
  settled.verdict = "settled";
  settled.phi = 0.72;
  settled.phi_bound = 1e-3;
  settled.Z_backbone = settled.backbone = 5;
  const Point p = points_of(table).front();
  EXPECT_EQ(p.jammed, 1u);
  EXPECT_EQ(p.settled, 1u);
  EXPECT_DOUBLE_EQ(p.mean_phi_J->mean, 0.71);
  EXPECT_NEAR(p.mean_phi_J->half_width, 12.7062 * 0.01 + 1e-3 / 2, 1e-5);
}

// Before there were settled samples a table had no column for their bound.
TEST(SampleTable, ReadsThoseOfOlderVersions) {
  SampleTable table = paper_table();
  table.rows = {jammed_row("5.0", "0.3", "0.1", 1, 0.7)};
  const std::string text = csv(table);
  std::string older;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) older += line.substr(0, line.rfind(',')) + "\n";
  const TemporaryFolder folder;
  write_file(folder / sample_table_name, older);
  EXPECT_EQ(csv(read_sample_table(folder / "")), text) << "its preset was empty";
}

TEST(Points, WithoutAJammedSampleHaveNoMean) {
  SampleTable table = paper_table();
  table.rows = {spent_row("5.0", "0.3", "0.1", 1)};
  const auto points = points_of(table);
  ASSERT_EQ(points.size(), 1u);
  EXPECT_FALSE(points[0].mean_phi_J);
  EXPECT_THAT(curves_of(points, table.keys), IsEmpty());
}

SampleTable model_curve() {
  SampleTable table = paper_table();
  for (const char* f : {"0.5", "0.1", "0.2", "0.3", "0.4", "0.25", "0.35"})
    for (int seed = 1; seed <= 3; ++seed)
      table.rows.push_back(
          jammed_row("20.0", f, "0.3", seed, FurnasModel{0.588}.phi(std::stod(f)) + 0.0005 * (seed - 2)));
  return table;
}

TEST(Curves, HaveTheirMaximum) {
  const SampleTable table = model_curve();
  const auto curves = curves_of(points_of(table), table.keys);
  ASSERT_EQ(curves.size(), 1u);
  EXPECT_EQ(curves[0].points.front().small_fraction, 0.1);
  const auto m = maximum_of(curves[0]);
  ASSERT_TRUE(m);
  EXPECT_EQ(m->at, 0.3);
  EXPECT_NEAR(m->f_max, FurnasModel{0.588}.f_max(), 0.01);
  EXPECT_LE(m->f_max_low, m->f_max);
  EXPECT_LE(m->f_max, m->f_max_high);
}

TEST(Refinement, AddsPointsWhereTheMaximumMayBe) {
  CurveMaximum m{};
  m.f_max = 0.3;
  m.f_max_low = 0.2;
  m.f_max_high = 0.4;
  EXPECT_THAT(fractions_to_add({0.2, 0.3, 0.4}, m), ElementsAre(0.25, 0.35));
  m.f_max = 0.32;
  EXPECT_THAT(fractions_to_add({0.2, 0.3, 0.4}, m), ElementsAre(0.32, 0.26, 0.36));
  m.f_max = 0.3;
  m.f_max_low = 0.292;
  m.f_max_high = 0.308;
  EXPECT_THAT(fractions_to_add({0.2, 0.3, 0.4}, m), IsEmpty());
}

}  // namespace
}  // namespace furnas
