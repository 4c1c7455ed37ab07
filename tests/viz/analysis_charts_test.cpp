#include "viz/analysis_charts.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace furnas {
namespace {

/// An analysis of forces that fall off as exp(-f), of one kind or of two.
Analysis exponential(bool two_kinds, bool logarithmic, double friction) {
  Analysis a;
  a.large = 90;
  a.small = two_kinds ? 10 : 0;
  a.friction = friction;
  std::vector<double> forces;
  for (int n = 1; n < 2000; ++n) forces.push_back(-std::log(n / 2000.0));
  ContactAnalysis contacts;
  contacts.normal.histogram =
      histogram(forces, logarithmic ? logarithmic_edges(10, 1e-4, 8) : linear_edges(0.2, 8));
  contacts.tangential = contacts.normal;
  if (friction > 0)
    contacts.mobilisation = Mobilisation{4, 1, 0, 0.5, histogram({0.1, 0.4, 0.6, 1}, {0, 0.5, 1})};
  NetworkAnalysis network;
  network.backbone = {contacts};
  for (const PairKind kind : two_kinds ? std::vector{PairKind::large_large, PairKind::large_small}
                                       : std::vector{PairKind::large_large}) {
    contacts.kind = kind;
    network.backbone.push_back(contacts);
  }
  for (const int least : {2, 3, 4})
    for (const double share : {0.0, 0.01, 0.1}) {
      RattlerCount count;
      count.least_contacts = least;
      count.large = least == 4 ? 90 : 9 * least;
      count.backbone = least == 4 ? 0 : 50;
      network.rattlers.push_back({share, count});
    }
  a.network = network;
  return a;
}

std::map<std::string, Chart> charts_of(const Analysis& a) {
  std::map<std::string, Chart> charts;
  for (const auto& [name, chart] : analysis_charts(a)) charts[name] = chart;
  return charts;
}

TEST(AnalysisCharts, DrawWhatThereIs) {
  EXPECT_EQ(charts_of(exponential(false, false, 0.3)).size(), 4U);
  const auto frictionless = charts_of(exponential(false, false, 0));
  EXPECT_EQ(frictionless.size(), 2U);
  EXPECT_TRUE(frictionless.contains("normal_forces"));
  EXPECT_TRUE(frictionless.contains("rattlers"));
  EXPECT_TRUE(analysis_charts({}).empty());
}

TEST(AnalysisCharts, NameKindsWhereThereAreSeveral) {
  for (const char* name : {"normal_forces", "tangential_forces", "mobilisation"}) {
    const Chart one = charts_of(exponential(false, false, 0.3)).at(name),
                two = charts_of(exponential(true, false, 0.3)).at(name);
    ASSERT_EQ(one.series.size(), 1U) << name;
    EXPECT_EQ(one.series[0].name, "");
    ASSERT_EQ(two.series.size(), 2U) << name;
    EXPECT_EQ(two.series[0].name, "large-large");
    EXPECT_EQ(two.series[1].name, "large-small");
    EXPECT_NE(two.series[0].colour, two.series[1].colour);
  }
}

/// The points lie on the density that the forces were drawn from, in bins of any shape.
TEST(AnalysisCharts, PointsStandOnTheDensity) {
  for (const bool logarithmic : {false, true}) {
    const Chart chart = charts_of(exponential(false, logarithmic, 0)).at("normal_forces");
    EXPECT_EQ(chart.x.logarithmic, logarithmic);
    EXPECT_TRUE(chart.y.logarithmic);
    const Series& s = chart.series.at(0);
    EXPECT_GT(s.x.size(), 20U);
    for (std::size_t k = 0; k < s.x.size(); ++k) {
      // Five errors, and two in a hundred: an exponential falls over a bin.
      EXPECT_NEAR(s.y[k], std::exp(-s.x[k]), 5 * s.bars[k].above + 0.02 * s.y[k]) << s.x[k];
    }
  }
}

TEST(AnalysisCharts, RattlersAreSharesAndNoShareIsThatOfAnEmptyBackbone) {
  const Chart chart = charts_of(exponential(false, false, 0)).at("rattlers");
  ASSERT_EQ(chart.series.size(), 2U) << "with four contacts needed no backbone is left";
  EXPECT_EQ(chart.series[0].x, (std::vector<double>{0.01, 0.1})) << "a logarithmic axis has no zero";
  EXPECT_EQ(chart.series[0].y, (std::vector<double>{0.2, 0.2}));
  EXPECT_EQ(chart.series[1].y, (std::vector<double>{0.3, 0.3}));
}

TEST(AnalysisCharts, DistancesAreMeasuredInContacts) {
  Analysis a;
  PairCorrelation p;
  p.kind = PairKind::large_large;
  p.contact = 4;
  p.edges = {0, 1, 2, 3, 4, 5, 6};
  p.g = {0, 0, 0, 9, 2, 1};
  a.pairs = {p};
  p.kind = {};
  a.pairs.push_back(p);
  const Chart chart = charts_of(a).at("pair_correlation");
  ASSERT_EQ(chart.series.size(), 1U) << "all together have no one contact distance";
  EXPECT_EQ(chart.series[0].x, (std::vector<double>{3.5 / 4, 4.5 / 4, 5.5 / 4}));
  EXPECT_EQ(chart.series[0].y, (std::vector<double>{9, 2, 1}));
}

}  // namespace
}  // namespace furnas
