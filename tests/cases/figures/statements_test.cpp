#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cases/program/figures/report.h"
#include "engine/base/require.h"
#include "tests/cases/figures/made_points.h"
#include "tests/cases/sweep/made_rows.h"
#include "tests/io/packings.h"

namespace furnas {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// Adds three samples around phi.
void add(SampleTable& table, const std::string& alpha, const std::string& f, const std::string& mu,
         double phi) {
  for (int k = -1; k <= 1; ++k) table.rows.push_back(jammed_row(alpha, f, mu, k + 2, phi + 0.0005 * k));
}

/// A study that agrees with the model at size ratio 20, and at 2 less.
SampleTable agreeing() {
  SampleTable table = paper_table();
  for (const auto& [mu, mono] : {std::pair{"0.0", 0.637}, {"0.3", 0.589}}) {
    add(table, "1.0", "0.0", mu, mono);
    for (const char* f : {"0.1", "0.2", "0.265", "0.29", "0.35", "0.5", "0.7"}) {
      const double model = FurnasModel{mono}.phi(std::stod(f));
      add(table, "20.0", f, mu, model);
      add(table, "2.0", f, mu, mono + 0.2 * (model - mono));
    }
  }
  for (SampleRow& row : table.rows) {
    const std::int64_t rattlers = row.small_fraction < (row.friction > 0 ? 0.28 : 0.25) ? 990 : 20;
    row.small_rattlers = {rattlers, rattlers, rattlers};
  }
  return table;
}

Study study_from(const SampleTable& table) {
  const TemporaryFolder folder;
  write_file(folder / sample_table_name, csv(table));
  return study_of({folder / ""});
}

const Statement& about(const std::vector<Statement>& all, const std::string& what) {
  for (const Statement& s : all)
    if (s.what.find(what) != s.what.npos) return s;
  throw std::runtime_error(what);
}

TEST(Studies, AreInTheOrderOfThePaper) {
  const Study study = study_from(agreeing());
  EXPECT_THAT(study.size_ratios(), ElementsAre(2, 20));
  EXPECT_THAT(study.frictions(), ElementsAre(0, 0.3));
  ASSERT_EQ(study.mono.size(), 2u);
  EXPECT_NEAR(study.model(0.3)->middle().mono, 0.589, 1e-12);
  EXPECT_FALSE(study.model(0.1));
  EXPECT_EQ(study.curve(20, 0)->points.size(), 7u);
  EXPECT_EQ(study.curve(3, 0), nullptr);
  EXPECT_TRUE(study.history.empty());
}

TEST(Studies, TakeTheLargestSamples) {
  SampleTable table = paper_table();
  add(table, "1.0", "0.0", "0.3", 0.6);
  add(table, "1.0", "0.0", "0.3", 0.58);
  for (std::size_t k = 3; k < 6; ++k) table.rows[k].large = 1000;
  const Study study = study_from(table);
  EXPECT_EQ(study.mono[0].samples, 3u);
  EXPECT_NEAR(study.mono[0].mean_phi_J->mean, 0.58, 1e-12);
  EXPECT_THAT(study.remarks, ElementsAre(HasSubstr("3 samples with fewer large spheres")));
}

TEST(Studies, CountARunInTwoFoldersOnce) {
  SampleTable table = paper_table();
  add(table, "1.0", "0.0", "0.3", 0.58);
  const TemporaryFolder folder;
  write_file(folder / sample_table_name, csv(table));
  table.rows[0].state_hash = "another run with this seed";
  const TemporaryFolder other;
  write_file(other / sample_table_name, csv(table));
  EXPECT_EQ(study_of({folder / "", folder / ""}).mono[0].samples, 3u);
  EXPECT_EQ(study_of({folder / "", other / ""}).mono[0].samples, 4u);
}

TEST(Studies, RefuseKeysThatThePaperDoesNotVary) {
  SampleTable table = agreeing();
  table.keys.emplace_back("compaction.pressure");
  for (SampleRow& row : table.rows) row.values.emplace_back("1e-4");
  EXPECT_NO_THROW(study_from(table));
  table.rows.back().values.back() = "1e-3";
  EXPECT_THROW(study_from(table), InputError);
}

TEST(Statements, AgreeWhereTheStudyDoes) {
  const auto all = statements_of(study_from(agreeing()));
  for (const char* what :
       {"equal spheres, μ = 0:", "equal spheres, μ = 0.3:", "rises to a maximum", "friction lowers",
        "α = 20, μ = 0, f_s = 0.265", "within 2 %", "α = 2: φ_max", "f_max rises", "rattle below"})
    EXPECT_EQ(about(all, what).agreement, Agreement::reproduced) << what << ": " << about(all, what).ours;
  EXPECT_EQ(about(all, "α = 40, μ = 0").agreement, Agreement::not_reachable);
}

TEST(Statements, DisagreeWhereTheStudyDoes) {
  SampleTable table = agreeing();
  for (SampleRow& row : table.rows) {
    row.phi_J -= 0.03 + (row.friction == 0 ? 0.08 : 0);
    if (row.small_fraction < 0.25) row.small_rattlers = {500, 500, 500};
  }
  const auto all = statements_of(study_from(table));
  for (const char* what : {"equal spheres, μ = 0:", "equal spheres, μ = 0.3:", "friction lowers",
                           "α = 20, μ = 0, f_s = 0.265", "rattle below"})
    EXPECT_EQ(about(all, what).agreement, Agreement::not_reproduced) << what << ": " << about(all, what).ours;
}

TEST(Statements, AreNotToldFromOneSideOfTheMaximum) {
  for (const bool left : {true, false}) {
    SampleTable table = agreeing();
    std::erase_if(table.rows, [left](const SampleRow& row) {
      return row.size_ratio == 20 && (row.small_fraction < 0.28) != left;
    });
    EXPECT_EQ(about(statements_of(study_from(table)), "rattle below").agreement, Agreement::not_reachable);
  }
}

TEST(Statements, OfTheLargestSizeRatioTakeOneThatCanAnswer) {
  SampleTable table = agreeing();
  add(table, "40.0", "0.292", "0.3", 0.83);
  const auto all = statements_of(study_from(table));
  for (const char* what : {"within 2 % of the model", "f_max rises", "rattle below"}) {
    EXPECT_EQ(about(all, what).agreement, Agreement::reproduced) << what;
    EXPECT_THAT(about(all, what).ours, HasSubstr("α = 20"));
  }
  EXPECT_EQ(about(all, "f_max rises").n, "42") << "three samples at seven f_s of two frictions";
}

TEST(Statements, AreNotToldFromACurveThatEndsBeforeItsMaximum) {
  SampleTable table = agreeing();
  for (const char* f : {"0.1", "0.15", "0.2"}) add(table, "40.0", f, "0.3", 0.5 + std::stod(f));
  const auto all = statements_of(study_from(table));
  for (const char* what : {"rises to a maximum", "within 2 % of the model", "f_max rises"})
    EXPECT_EQ(about(all, what).agreement, Agreement::reproduced) << what << ": " << about(all, what).ours;
}

/// What the paper says of all frictions is not told from one of them.
TEST(Statements, OfAllFrictionsNeedEachOfThem) {
  SampleTable table = agreeing();
  std::erase_if(table.rows, [](const SampleRow& row) { return row.size_ratio == 20 && row.friction == 0; });
  const auto all = statements_of(study_from(table));
  for (const char* what : {"within 2 % of the model", "rattle below"}) {
    EXPECT_EQ(about(all, what).agreement, Agreement::not_reachable) << what;
    EXPECT_THAT(about(all, what).ours, HasSubstr("μ = 0.3")) << what;
  }
}

TEST(Statements, TakeTheNearestPoint) {
  SampleTable table = agreeing();
  add(table, "20.0", "0.295", "0.3", 0.7);
  EXPECT_EQ(about(statements_of(study_from(table)), "α = 20, μ = 0.3, f_s = 0.29").agreement,
            Agreement::reproduced);
}

TEST(Statements, OfNothingAreNotReachable) {
  for (const Statement& s : statements_of(Study{})) {
    EXPECT_EQ(s.agreement, Agreement::not_reachable) << s.what;
    EXPECT_EQ(s.ours, "-") << s.what;
  }
}

Agreement of_number(std::vector<double> phi_J, std::int64_t large = 100) {
  Study study;
  study.curves = {{{point(20, 0.29, 0.3, std::move(phi_J), large)}}};
  return about(statements_of(study), "α = 20, μ = 0.3, f_s = 0.29").agreement;  // 0.823
}

TEST(Statements, AnIntervalThatHoldsNearlyAllAgreesWithNothing) {
  EXPECT_EQ(of_number({0.820, 0.821, 0.822}), Agreement::reproduced);
  EXPECT_EQ(of_number({0.80, 0.85}), Agreement::not_reachable);
  EXPECT_EQ(of_number({0.75, 0.77}), Agreement::not_reachable);
  EXPECT_EQ(of_number({0.760, 0.761, 0.762}), Agreement::not_reproduced);
}

TEST(Statements, CellsTooThinDecideNothing) {
  SampleTable table = agreeing();
  for (SampleRow& row : table.rows)
    if (row.size_ratio == 20) row.thickness = 2.4;
  const Study study = study_from(table);
  const auto all = statements_of(study);
  for (const char* what : {"α = 20, μ = 0.3, f_s = 0.29", "within 2 %", "rattle below"})
    EXPECT_EQ(about(all, what).agreement, Agreement::not_reachable) << what;
  EXPECT_THAT(about(all, "α = 20, μ = 0.3, f_s = 0.29").ours, HasSubstr("2.4 largest diameters thick"));
  EXPECT_EQ(about(all, "α = 2: φ_max").agreement, Agreement::reproduced) << "of thicker cells";
  const auto figures = figures_of(study);
  EXPECT_THAT(report(study, figures), HasSubstr("| 2.4, too thin |"));
  std::size_t open = 0, filled = 0;
  for (const Series& s : figures.front().chart.series)
    for (std::size_t k = 0; k < s.open.size(); ++k) {
      if (s.name.find("α = 20") != s.name.npos) {
        EXPECT_TRUE(s.open[k]);
      }
      if (std::isfinite(s.x[k])) ++(s.open[k] ? open : filled);
    }
  EXPECT_EQ(open, 7u);
  EXPECT_EQ(filled, 7u + 2u) << "size ratio 2, and equal spheres at both ends";
  EXPECT_THAT(csv(figures.front().chart), HasSubstr("yes\n"));
}

TEST(Statements, ALoneSampleCountsIfItIsLarge) {
  EXPECT_EQ(of_number({0.82}), Agreement::not_reachable);
  EXPECT_EQ(of_number({0.82}, 1000), Agreement::reproduced);
  EXPECT_EQ(of_number({0.76}, 1000), Agreement::not_reproduced);
}

TEST(Statements, ALoneSampleHasThePooledScatter) {
  const auto of = [](double scatter, double phi, std::int64_t large) {
    return about(statements_of(with_a_lone_sample(scatter, phi, large)), "α = 20, μ = 0.3, f_s = 0.29");
  };
  // 100 large spheres scatter by 0.002; six degrees of freedom, t(6) = 2.44691, 25 large spheres: twice as
  // far.
  const Statement s = of(0.002, 0.82, 25);
  EXPECT_EQ(s.agreement, Agreement::reproduced);
  EXPECT_EQ(s.ours, "0.8200 ± 0.0098 by pooled scatter");
  EXPECT_EQ(of(0.002, 0.80, 25).agreement, Agreement::not_reproduced);
  EXPECT_EQ(of(0.002, 0.80, 6).agreement, Agreement::not_excluded)
      << "within the interval of six large spheres";
  EXPECT_EQ(of(0.02, 0.82, 25).agreement, Agreement::not_reachable) << "the interval is too wide";
}

/// The rise of f_max at a size ratio whose points are too few for an interval gives way to a smaller ratio.
TEST(Statements, TheRiseOfFMaxIsReadWhereItIsKnown) {
  SampleTable table = agreeing();
  for (const char* f : {"0.1", "0.28", "0.5"})
    for (const auto& [mu, mono] : {std::pair{"0.0", 0.637}, {"0.3", 0.589}})
      table.rows.push_back(jammed_row("40.0", f, mu, 1, FurnasModel{mono}.phi(std::stod(f))));
  EXPECT_THAT(about(statements_of(study_from(table)), "f_max rises").ours, HasSubstr("α = 20"));
}

Agreement of_curve(double first, double middle, double last, double scatter) {
  Study study;
  const auto at = [&](double f, double phi) { return point(3, f, 0.3, {phi - scatter, phi, phi + scatter}); };
  study.curves = {{{at(0.1, first), at(0.3, middle), at(0.5, last)}}};
  return about(statements_of(study), "rises to a maximum").agreement;
}

TEST(Statements, AMaximumIsToldFromScatter) {
  EXPECT_EQ(of_curve(0.65, 0.70, 0.66, 0.001), Agreement::reproduced);
  EXPECT_EQ(of_curve(0.65, 0.70, 0.66, 0.05), Agreement::not_reachable);
  EXPECT_EQ(of_curve(0.65, 0.66, 0.70, 0.001), Agreement::not_reproduced);
}

TEST(Statements, AMaximumIsToldByAnyPointThatCanBe) {
  Study study;
  study.curves = {{{point(3, 0.1, 0.3, {0.65, 0.651}), point(3, 0.2, 0.3, {0.70, 0.701}),
                    point(3, 0.3, 0.3, {0.71}), point(3, 0.5, 0.3, {0.66, 0.661})}}};
  EXPECT_EQ(about(statements_of(study), "rises to a maximum").agreement, Agreement::reproduced)
      << "the lone sample is higher, but nobody knows how it scatters";
}

TEST(Studies, TheModelOfTwoSamplesThatDifferStaysPossible) {
  Study study;
  study.mono = {point(1, 0, 0.3, {0.52, 0.60})};  // 0.56 +- 0.51
  const auto model = study.model(0.3);
  ASSERT_TRUE(model);
  EXPECT_LT(model->phi(0).low, 0.06);
  EXPECT_GT(model->phi(0).high, 0.99);
  EXPECT_LT(model->phi(0).high, 1);
  EXPECT_EQ(about(statements_of(study), "equal spheres, μ = 0.3").agreement, Agreement::not_reachable);
}

TEST(Figures, ALoneSampleHasNoBar) {
  SampleTable table = paper_table();
  add(table, "1.0", "0.0", "0.3", 0.59);
  table.rows.push_back(jammed_row("20.0", "0.29", "0.3", 1, 0.82));
  const auto figures = figures_of(study_from(table));
  std::size_t points = 0;
  for (const Figure& figure : figures)
    for (const Series& s : figure.chart.series) {
      if (s.name.find("α = 20") == s.name.npos && s.name.find("fewer than") == s.name.npos) continue;
      for (const Bar& bar : s.bars) EXPECT_EQ(bar.below + bar.above, 0) << figure.name << ": " << s.name;
      points += s.bars.size();
    }
  EXPECT_GE(points, 6u) << "phi_J, phi_L, phi_S and the rattlers by three thresholds";
}

TEST(Report, ShowsEachStatementAndFigure) {
  const Study study = study_from(agreeing());
  const auto figures = figures_of(study);
  const std::string text = report(study, figures);
  for (const Statement& s : statements_of(study)) EXPECT_THAT(text, HasSubstr(s.what));
  for (const Figure& f : figures) EXPECT_THAT(text, HasSubstr("](" + f.name + ".svg)"));
}

TEST(Figures, AreThoseOfThePaper) {
  std::vector<std::string> names;
  for (const Figure& f : figures_of(study_from(agreeing()))) {
    names.push_back(f.name);
    EXPECT_FALSE(f.caption.empty());
    EXPECT_THAT(csv(f.chart), HasSubstr("series,x,y,low,high,too_thin\n"));
  }
  EXPECT_THAT(names, ElementsAre("figure_2_friction_0", "figure_2_friction_0.3", "figure_3a_phi_max",
                                 "figure_3b_f_max", "figure_4_rattlers_size_ratio_2",
                                 "figure_4_rattlers_size_ratio_20", "phi_large_friction_0",
                                 "phi_small_friction_0", "phi_large_friction_0.3", "phi_small_friction_0.3"));
}

}  // namespace
}  // namespace furnas
