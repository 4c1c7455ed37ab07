#include "viz/chart/layout.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/base/require.h"

namespace furnas {
namespace {

Chart chart_of(const Series& series) {
  Chart chart;
  chart.x.title = std::string("x");  // GCC 12 warns of a copy that is none where a literal is assigned
  chart.y.title = std::string("y");
  chart.series = {series};
  return chart;
}

/// Whether a point of the data lies in the legend's box.
bool covered(const ChartLayout& layout, double x, double y) {
  const Box &f = layout.frame, &l = layout.legend;
  const double px = f.left + (x - layout.x.low) / (layout.x.high - layout.x.low) * (f.right - f.left);
  const double py = f.bottom + (y - layout.y.low) / (layout.y.high - layout.y.low) * (f.top - f.bottom);
  return px >= l.left && px <= l.right && py >= l.bottom && py <= l.top;
}

TEST(ChartLayout, HoldsAllDataAndEndsOnMarks) {
  const ChartLayout layout = layout_of(chart_of({"", {0.13, 4.7}, {-0.2, 0.93}, {{0.1, 0}, {0, 0.2}}}));
  EXPECT_DOUBLE_EQ(layout.x.low, 0);
  EXPECT_DOUBLE_EQ(layout.x.high, 5);
  EXPECT_NEAR(layout.y.low, -0.4, 1e-12) << "the error bar reaches to -0.3";
  EXPECT_NEAR(layout.y.high, 1.2, 1e-12);
  EXPECT_EQ(layout.legend.right, 0) << "no names, no legend";
}

TEST(ChartLayout, LogarithmicAxesLeaveOutWhatTheyCannotShow) {
  Chart chart = chart_of({"", {1, 10, 3, 5}, {0.03, 30, 0, -2}});
  chart.x.logarithmic = chart.y.logarithmic = true;
  const ChartLayout layout = layout_of(chart);
  EXPECT_NEAR(layout.x.low, 0, 1e-12);
  EXPECT_NEAR(layout.x.high, 1, 1e-12);
  EXPECT_NEAR(layout.y.low, std::log10(0.02), 1e-12);
  EXPECT_NEAR(layout.y.high, std::log10(50), 1e-12);
}

TEST(ChartLayout, KeepsTheEndsItIsTold) {
  Chart chart = chart_of({"data", {0, 1}, {0, 1}});
  chart.x.low = 0.25;
  chart.y.high = 0.5;
  const ChartLayout layout = layout_of(chart);
  EXPECT_EQ(layout.x.low, 0.25);
  EXPECT_EQ(layout.y.high, 0.5);
  chart.y.low = 0.7;
  EXPECT_THROW(layout_of(chart), ContractError) << "the ends are in disorder";
  chart.y.low = -1;
  chart.y.logarithmic = true;
  EXPECT_THROW(layout_of(chart), ContractError);
}

TEST(ChartLayout, ShowsOnePointAndNone) {
  for (const Series& s : {Series{"one", {3}, {7}}, Series{"none", {}, {}}, Series{"zero", {0}, {0}},
                          Series{"lost", {NAN}, {1}}})
    for (const bool logarithmic : {false, true}) {
      Chart chart = chart_of(s);
      chart.y.logarithmic = logarithmic;
      const ChartLayout layout = layout_of(chart);
      EXPECT_LT(layout.x.low, layout.x.high) << s.name;
      EXPECT_LT(layout.y.low, layout.y.high) << s.name;
      EXPECT_GE(layout.y_ticks.size(), 2U) << s.name;
    }
}

/// As many curves as the study has: its legend is half as high as the chart.
TEST(ChartLayout, AHighLegendCoversNoData) {
  Chart chart = chart_of({"a series", {}, {}, {}, blue, LineStyle::solid, Marker::circle});
  for (int n = 0; n <= 20; ++n) {
    chart.series[0].x.push_back(n);
    chart.series[0].y.push_back(n * (20 - n));
  }
  chart.series.resize(7, chart.series[0]);
  const ChartLayout layout = layout_of(chart);
  EXPECT_GT(layout.legend.top - layout.legend.bottom, 0.4 * (layout.frame.top - layout.frame.bottom));
  for (std::size_t n = 0; n < chart.series[0].x.size(); ++n)
    EXPECT_FALSE(covered(layout, chart.series[0].x[n], chart.series[0].y[n])) << n;
}

/// Data in three corners leave the fourth; data everywhere push the axis up.
TEST(ChartLayout, TheLegendCoversNoData) {
  const std::vector<Spot> corners{{0, 0}, {1, 0}, {0, 1}, {1, 1}};
  for (std::size_t free = 0; free < corners.size(); ++free) {
    Series s{"a series", {}, {}, {}, blue, LineStyle::none, Marker::circle};
    for (std::size_t k = 0; k < corners.size(); ++k) {
      if (k == free) continue;
      s.x.push_back(corners[k].x);
      s.y.push_back(corners[k].y);
    }
    Chart chart = chart_of(s);
    chart.y.low = 0, chart.y.high = 1;
    const ChartLayout layout = layout_of(chart);
    EXPECT_EQ(layout.legend.left < 0.5 * (layout.frame.left + layout.frame.right), corners[free].x == 0)
        << free;
    EXPECT_EQ(layout.legend.bottom < 0.5 * (layout.frame.bottom + layout.frame.top), corners[free].y == 0)
        << free;
  }
  Series everywhere{
      "a series of points that fill all the space", {}, {}, {}, blue, LineStyle::none, Marker::circle};
  for (int n = 0; n < 400; ++n) {
    everywhere.x.push_back(n % 20);
    everywhere.y.push_back(n / 20);
  }
  Chart chart = chart_of(everywhere);
  const ChartLayout layout = layout_of(chart);
  EXPECT_GT(layout.y.high, 20);
  for (std::size_t k = 0; k < everywhere.x.size(); ++k)
    EXPECT_FALSE(covered(layout, everywhere.x[k], everywhere.y[k])) << k;
}

TEST(ChartLayout, ALegendWithoutRoomStandsRightOfTheFrame) {
  Series everywhere{"a series", {}, {}, {}, blue, LineStyle::none, Marker::circle};
  for (int n = 0; n < 400; ++n) {
    everywhere.x.push_back(n % 20);
    everywhere.y.push_back(n / 20);
  }
  Chart chart = chart_of(everywhere);
  chart.y.high = 19;
  const ChartLayout layout = layout_of(chart);
  EXPECT_EQ(layout.y.high, 19);
  EXPECT_GT(layout.legend.left, layout.frame.right);
  EXPECT_LT(layout.legend.right, chart.width);
  EXPECT_GT(layout.frame.right - layout.frame.left, 0.5 * chart.width);
  chart.y.high.reset();
  chart.series.resize(12, everywhere);
  const ChartLayout high = layout_of(chart);
  EXPECT_GT(high.legend.left, high.frame.right) << "room above would take more than the data";
  EXPECT_LE(high.y.high, 20);
}

TEST(ChartLayout, NothingLeavesTheChart) {
  Chart chart = chart_of({"a name", {0, 1e-5}, {-1234567, 12345}});
  chart.title = "title";
  for (const auto& [width, height] :
       {std::pair(1200, 900), std::pair(400, 300), std::pair(1600, 500), std::pair(500, 900)}) {
    chart.width = width;
    chart.height = height;
    const ChartLayout layout = layout_of(chart);
    const ChartSizes size = sizes_of(chart);
    EXPECT_GT(layout.frame.left, size.title + size.label) << "room for the title and the numbers";
    EXPECT_GT(layout.frame.bottom, size.title + size.label);
    EXPECT_LT(layout.frame.top, height - size.title);
    EXPECT_LT(layout.frame.right, width);
    EXPECT_GT(layout.frame.right - layout.frame.left, 0.5 * width);
    EXPECT_GT(layout.frame.top - layout.frame.bottom, 0.5 * height);
  }
}

}  // namespace
}  // namespace furnas
