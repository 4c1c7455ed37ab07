#include "cases/program/figures/plot.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cases/program/figures/gather.h"
#include "cases/program/sweep/base_case.h"
#include "engine/base/require.h"
#include "engine/statistics/furnas_model.h"
#include "tests/cases/sweep/made_rows.h"
#include "tests/io/packings.h"

namespace furnas {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// The text of a base_case.toml of which all but this is the default.
std::string base_case_with(const std::string& text) { return "[mixture]\nlarge = 100\n" + text; }

/// Two samples at each f_s of size ratio 5, by each friction, near the model of an equal packing.
SampleTable mixtures(std::initializer_list<const char*> frictions) {
  SampleTable table = paper_table();
  for (const char* mu : frictions)
    for (const char* f : {"0.1", "0.3", "0.5"})
      for (const int seed : {1, 2})
        table.rows.push_back(
            jammed_row("5.0", f, mu, seed, FurnasModel{0.6}.phi(std::stod(f)) - 0.01 * seed));
  return table;
}

SampleTable equal_spheres(std::initializer_list<const char*> frictions) {
  SampleTable table = paper_table();
  for (const char* mu : frictions)
    for (const int seed : {1, 2}) table.rows.push_back(jammed_row("1.0", "0.0", mu, seed, 0.6));
  return table;
}

/// Folders of sweeps that exist as long as this.
class MadeSweeps {
 public:
  std::filesystem::path add(const SampleTable& table, const std::string& base = "") {
    const std::filesystem::path folder = folder_ / std::to_string(count_++);
    std::filesystem::create_directories(folder);
    write_file(folder / sample_table_name, csv(table));
    if (!base.empty()) write_file(folder / base_case_name, base_case_with(base));
    return folder;
  }

 private:
  TemporaryFolder folder_;
  int count_ = 0;
};

const Series& series_named(const Chart& chart, const std::string& name) {
  for (const Series& s : chart.series)
    if (s.name == name) return s;
  throw std::runtime_error("no series " + name);
}

std::string refusal_of(const PlotOrder& order) {
  try {
    plot_of(order);
  } catch (const InputError& error) {
    return error.what();
  }
  return "nothing is refused";
}

TEST(Plots, DrawAColumnAgainstAKeyWithCurvesByAnother) {
  MadeSweeps made;
  const auto folder = made.add(mixtures({"0.1", "0.3"}));
  const Plot plot = plot_of({.sweeps = {folder}, .x = "small_fraction", .y = "steps", .by = {"friction"}});
  EXPECT_EQ(plot.name, "steps_against_small_fraction_by_friction");
  EXPECT_EQ(plot.x, "mixture.small_fraction");
  ASSERT_EQ(plot.chart.series.size(), 2u);
  EXPECT_THAT(series_named(plot.chart, "μ = 0.3").x, ElementsAre(0.1, 0.3, 0.5));
  EXPECT_THAT(series_named(plot.chart, "μ = 0.3").y, ElementsAre(1000, 1000, 1000));
  EXPECT_EQ(plot.chart.title, "α = 5");
  EXPECT_EQ(plot_of({.sweeps = {folder}, .x = "f_s", .y = "steps", .by = {"mu"}}).name, plot.name)
      << "by the symbols";
}

TEST(Plots, HaveErrorBarsOfStudentsT) {
  MadeSweeps made;
  const Plot plot = plot_of({.sweeps = {made.add(mixtures({"0.3"}))}});
  EXPECT_EQ(plot.x, "mixture.small_fraction") << "what varies";
  const Series& s = plot.chart.series.back();
  // Two samples 0.01 apart: 12.706 times 0.005.
  for (const Bar& bar : s.bars) EXPECT_NEAR(bar.above, 0.0635, 1e-4);
}

TEST(Plots, ShowTheModelWhereThereAreEqualSpheres) {
  MadeSweeps made;
  const auto mixed = made.add(mixtures({"0.1", "0.3"})), equal = made.add(equal_spheres({"0.1", "0.3"}));
  const Plot both = plot_of({.sweeps = {mixed, equal}});
  const Series& model = series_named(both.chart, "model, α = 5, μ = 0.3");
  EXPECT_EQ(model.x.size(), 501u);
  EXPECT_NEAR(*std::max_element(model.y.begin(), model.y.end()), FurnasModel{0.6}.phi_max(), 1e-3);
  EXPECT_THAT(both.remarks, testing::Not(testing::Contains(HasSubstr("no model"))));

  const Plot over = plot_of({.sweeps = {mixed, equal}, .x = "friction", .where = {"small_fraction=0.3"}});
  EXPECT_THAT(series_named(over.chart, "model").x, ElementsAre(0.1, 0.3)) << "of the equal spheres left out";
  EXPECT_NEAR(series_named(over.chart, "model").y.front(), FurnasModel{0.6}.phi(0.3), 1e-12);
}

TEST(Plots, SayHowToMakeEqualSpheresWhereTheModelNeedsThem) {
  MadeSweeps made;
  const auto folder = made.add(mixtures({"0.1", "0.3"}));
  EXPECT_THAT(plot_of({.sweeps = {folder}}).remarks,
              ElementsAre(testing::AllOf(HasSubstr("no model at friction 0.1, 0.3:"),
                                         HasSubstr("for the first: furnas sweep"),
                                         HasSubstr("contact.friction=0.1"))));
}

TEST(Plots, OfOneCurveNeedNoLegend) {
  MadeSweeps made;
  SampleTable table = mixtures({"0.3"});
  const Plot plot = plot_of({.sweeps = {made.add(table)}, .y = "Z"});
  ASSERT_EQ(plot.chart.series.size(), 1u);
  EXPECT_EQ(plot.chart.series[0].name, "");
}

TEST(Plots, RefuseToMixSamplesThatDifferInAnotherKey) {
  MadeSweeps made;
  const auto soft = made.add(mixtures({"0.3"}), "[compaction]\npressure = 1e-3\n"),
             hard = made.add(mixtures({"0.3"}), "[compaction]\npressure = 1e-2\n");
  EXPECT_THAT(refusal_of({.sweeps = {soft, hard}, .x = "small_fraction", .by = {"friction"}}),
              HasSubstr("differ in compaction.pressure (0.001, 0.01)"));
  const Plot plot = plot_of({.sweeps = {soft, hard}});
  EXPECT_EQ(plot.name, "phi_J_against_small_fraction_by_pressure") << "by default nothing is mixed";
  const Plot chosen = plot_of({.sweeps = {soft, hard}, .by = {"friction"}, .where = {"pressure=1e-2"}});
  EXPECT_EQ(chosen.chart.title, "α = 5, μ = 0.3, p_a = 0.01; bars: 95 %");
}

TEST(Plots, RefuseToMixNumbersOfSpheres) {
  MadeSweeps made;
  SampleTable larger = mixtures({"0.3"});
  for (SampleRow& row : larger.rows) row.large = 500;
  EXPECT_THAT(refusal_of({.sweeps = {made.add(mixtures({"0.3"})), made.add(larger)}}),
              HasSubstr("differ in mixture.large (100, 500)"));
}

TEST(Plots, SayWhatIsAllowed) {
  MadeSweeps made;
  const auto folder = made.add(mixtures({"0.1", "0.3"}));
  EXPECT_THAT(refusal_of({.sweeps = {folder}, .x = "presure"}), HasSubstr("allowed: mixture.size_ratio"));
  EXPECT_THAT(refusal_of({.sweeps = {folder}, .y = "verdict"}), HasSubstr("allowed: a number"));
  EXPECT_THAT(refusal_of({.sweeps = {folder}, .y = "phi_X"}), HasSubstr("result.json cannot be read"));
  EXPECT_THAT(refusal_of({.sweeps = {folder}, .where = {"friction"}}), HasSubstr("friction=0.3"));
  EXPECT_THAT(refusal_of({.sweeps = {folder}, .where = {"friction=7"}}),
              HasSubstr("contact.friction = 0.1, 0.3"));
  EXPECT_THAT(refusal_of({.sweeps = {made.add(equal_spheres({"0.3"}))}}), HasSubstr("--x is missing"));
}

TEST(Plots, OpenSymbolsAreOfThinCells) {
  MadeSweeps made;
  SampleTable table = mixtures({"0.3"});
  for (SampleRow& row : table.rows) row.thickness = row.small_fraction < 0.2 ? 2.4 : 4;
  const Plot plot = plot_of({.sweeps = {made.add(table)}, .y = "Z"});
  EXPECT_THAT(plot.chart.series.front().open, ElementsAre(true, false, false));
  EXPECT_THAT(plot.remarks, ElementsAre(HasSubstr("1 of 3 points")));
}

TEST(Gathered, ReadsOlderSweepsByTheCasesOfTheirSamples) {
  MadeSweeps made;
  const SampleTable table = mixtures({"0.3"});
  const auto folder = made.add(table);
  const auto run = folder / folder_of_sample(table.keys, table.rows[0].values, 1);
  std::filesystem::create_directories(run);
  write_file(run / "case.resolved.toml", base_case_with("[compaction]\npressure = 1e-3\n"));
  const auto other = made.add(table, "[compaction]\npressure = 1e-2\n");
  const Gathered all = gather({folder, other});
  ASSERT_EQ(all.varying().size(), 2u);
  EXPECT_EQ(all.varying()[1].key, "compaction.pressure");
  EXPECT_THAT(all.varying()[1].values, ElementsAre("0.001", "0.01"));
  EXPECT_THAT(all.remarks, IsEmpty());
  EXPECT_THAT(gather({made.add(table), other}).remarks, ElementsAre(HasSubstr("it is assumed")));
}

TEST(Gathered, KeysThatDoNotBearOnPhiDoNotTellSamplesApart) {
  MadeSweeps made;
  const SampleTable table = mixtures({"0.3"});
  const Gathered all = gather({made.add(table, "[stop]\nsteps = 5\n[compute]\nthreads = 2\n"),
                               made.add(table, "[output]\nhistory_every = 7\n")});
  EXPECT_EQ(all.table.rows.size(), table.rows.size()) << "the same runs in two folders";
  ASSERT_EQ(all.varying().size(), 1u);
}

}  // namespace
}  // namespace furnas
