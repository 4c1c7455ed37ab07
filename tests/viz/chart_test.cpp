#include "viz/chart.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <vtkNew.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLDataParser.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "engine/base/require.h"
#include "io/atomic_file.h"
#include "tests/io/packings.h"
#include "viz/chart/layout.h"

namespace furnas {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

bool looks(const Pixels& picture, double x, double y, const Colour& colour) {
  const auto at = 4 * (std::size_t(y) * std::size_t(picture.width) + std::size_t(x));
  for (std::size_t c = 0; c < 3; ++c)
    if (std::abs(picture.rgba[at + c] - 255 * colour[c]) > 3) return false;
  return true;
}

std::size_t pixels_of(const Pixels& picture, const Colour& colour) {
  std::size_t count = 0;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) count += looks(picture, x, y, colour);
  return count;
}

/// Pixels where a value is drawn.
Spot spot(const Chart& chart, double x, double y) {
  const ChartLayout layout = layout_of(chart);
  const Box& f = layout.frame;
  return {
      f.left + (shown(chart.x, x) - layout.x.low) / (layout.x.high - layout.x.low) * (f.right - f.left),
      f.bottom + (shown(chart.y, y) - layout.y.low) / (layout.y.high - layout.y.low) * (f.top - f.bottom)};
}

Chart three_series() {
  Chart chart;
  chart.title = "φ_J & <all>";
  chart.x.title = "r / d_s";
  chart.y.title = "density";
  chart.y.logarithmic = true;
  chart.width = 1000;
  chart.height = 750;
  Series line{"falling line", {}, {}, {}, blue};
  Series points{"points", {}, {}, {}, vermilion, LineStyle::none, Marker::square};
  for (int n = 0; n <= 10; ++n) {
    line.x.push_back(n);
    line.y.push_back(std::pow(10.0, -0.3 * n));
    points.x.push_back(n);
    points.y.push_back(0.01 * std::pow(10.0, 0.2 * n));
    points.bars.push_back({0.5 * points.y.back(), 0.5 * points.y.back()});
  }
  chart.series = {line, points, steps("bins", {0, 2, 5}, {0.002, 0.0006}, green)};
  return chart;
}

TEST(Chart, HasInkOfEachSeriesWhereItsDataAre) {
  const Chart chart = three_series();
  const Pixels picture = render(chart);
  ASSERT_EQ(picture.width, 1000);
  ASSERT_EQ(picture.height, 750);
  for (int n = 1; n < 10; ++n) {
    const Spot on_line = spot(chart, n, std::pow(10.0, -0.3 * n));
    if (n != 4) {  // where a point lies on the line
      EXPECT_TRUE(looks(picture, on_line.x, on_line.y, blue)) << n;
    }
    const double y = 0.01 * std::pow(10.0, 0.2 * n);
    const Spot point = spot(chart, n, y), bar = spot(chart, n, 1.3 * y);
    EXPECT_TRUE(looks(picture, point.x, point.y, vermilion)) << n;
    bool bar_is_there = false;
    for (const double off : {-1.0, 0.0, 1.0}) bar_is_there |= !looks(picture, bar.x + off, bar.y, {1, 1, 1});
    EXPECT_TRUE(bar_is_there) << n;
    const Spot beside = spot(chart, n + 0.5, 3 * y);
    EXPECT_TRUE(looks(picture, beside.x, beside.y, {1, 1, 1}) || n < 5) << n;
  }
  const Spot first = spot(chart, 1, 0.002), second = spot(chart, 4, 0.0006), riser = spot(chart, 2, 0.001);
  EXPECT_TRUE(looks(picture, first.x, first.y, green));
  EXPECT_TRUE(looks(picture, second.x, second.y, green));
  EXPECT_TRUE(looks(picture, riser.x, riser.y, green));
}

TEST(Chart, DrawsEachStyleDifferently) {
  Chart chart;
  chart.width = 1000;
  chart.height = 750;
  chart.legend = LegendPlace::none;
  chart.series = {{"", {0, 1}, {0.5, 0.5}, {}, blue}};
  const auto ink = [&](LineStyle line, Marker marker) {
    chart.series[0].line = line;
    chart.series[0].marker = marker;
    return pixels_of(render(chart), blue);
  };
  const std::size_t solid = ink(LineStyle::solid, Marker::none),
                    dashed = ink(LineStyle::dashed, Marker::none),
                    dotted = ink(LineStyle::dotted, Marker::none);
  EXPECT_GT(solid, 1000U);
  EXPECT_NEAR(double(dashed) / double(solid), 4 / 6.5, 0.1);
  EXPECT_NEAR(double(dotted) / double(solid), 1.2 / 3, 0.15);
  EXPECT_EQ(ink(LineStyle::none, Marker::none), 0U);
  for (const Marker marker :
       {Marker::circle, Marker::square, Marker::diamond, Marker::triangle, Marker::wedge})
    EXPECT_GT(ink(LineStyle::none, marker), 15U) << int(marker);
  for (const Marker marker : {Marker::cross, Marker::plus})
    EXPECT_GT(ink(LineStyle::none, marker), 3U) << int(marker);
}

TEST(Chart, OpenMarkersAreHollow) {
  Chart chart;
  chart.width = 1000;
  chart.height = 750;
  chart.series = {{"", {0, 1, 2}, {0, 1, 2}, {}, blue, LineStyle::none}};
  chart.series[0].open = {false, true, false};
  for (const Marker marker :
       {Marker::circle, Marker::square, Marker::diamond, Marker::triangle, Marker::wedge}) {
    chart.series[0].marker = marker;
    const Pixels picture = render(chart);
    const std::size_t ink = pixels_of(picture, blue);
    const Spot open = spot(chart, 1, 1), filled = spot(chart, 2, 2);
    EXPECT_TRUE(looks(picture, open.x, open.y, {1, 1, 1})) << int(marker);
    EXPECT_TRUE(looks(picture, filled.x, filled.y, blue)) << int(marker);
    chart.series[0].open = {true, true, true};
    EXPECT_LT(pixels_of(render(chart), blue), ink) << int(marker);
    chart.series[0].open = {false, true, false};
  }
}

TEST(Chart, KeepsLinesInItsFrameAndBreaksThemWhereDataAreMissing) {
  Chart chart;
  chart.width = 1000;
  chart.height = 750;
  chart.x.low = 0, chart.x.high = 4, chart.y.low = 0, chart.y.high = 1;
  chart.series = {{"", {0, 1, 2, 3, 4}, {0.5, 0.5, NAN, 0.5, 0.5}, {}, blue},
                  {"", {2, 2}, {-5, 5}, {}, green}};
  const Pixels picture = render(chart);
  const Box frame = layout_of(chart).frame;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      if (looks(picture, x, y, green)) {
        EXPECT_TRUE(y > frame.bottom - 2 && y < frame.top + 2) << x << " " << y;
      }
    }
  const Spot gap = spot(chart, 1.5, 0.5), there = spot(chart, 0.5, 0.5);
  EXPECT_TRUE(looks(picture, gap.x, gap.y, {1, 1, 1}));
  EXPECT_TRUE(looks(picture, there.x, there.y, blue));
}

/// The texts of all elements, in order.
void collect(vtkXMLDataElement& element, std::vector<std::string>& texts, std::size_t& polylines) {
  if (std::string(element.GetName()) == "text") texts.emplace_back(element.GetCharacterData());
  polylines += std::string(element.GetName()) == "polyline";
  for (int n = 0; n < element.GetNumberOfNestedElements(); ++n)
    collect(*element.GetNestedElement(n), texts, polylines);
}

TEST(Chart, SvgIsWellFormedAndContainsTheLabels) {
  const TemporaryFolder folder;
  const fs::path path = folder / "chart.svg";
  render_svg(three_series(), path);
  std::ifstream stream(path);
  vtkNew<vtkXMLDataParser> parser;
  parser->SetStream(&stream);
  ASSERT_TRUE(parser->Parse());
  std::vector<std::string> texts;
  std::size_t polylines = 0;
  collect(*parser->GetRootElement(), texts, polylines);
  std::string all;
  for (const std::string& text : texts) all += text + "|";
  EXPECT_THAT(all, HasSubstr("φ|J| & <all>|"));
  EXPECT_THAT(all, HasSubstr("r / d|s|"));
  for (const char* label : {"density|", "falling line|", "points|", "bins|", "0.01|", "10|"})
    EXPECT_THAT(all, HasSubstr(label));
  EXPECT_GT(polylines, 30U);
  const std::string file{std::istreambuf_iterator<char>(std::ifstream(path).rdbuf()), {}};
  EXPECT_THAT(file, HasSubstr("stroke=\"#0072b2\""));
  EXPECT_THAT(file, HasSubstr("width=\"1000\" height=\"750\""));
}

TEST(Chart, WritesAPng) {
  const TemporaryFolder folder;
  const fs::path path = folder / "chart.png";
  render_png(three_series(), path);
  std::ifstream stream(path, std::ios::binary);
  std::array<char, 8> head{};
  stream.read(head.data(), head.size());
  EXPECT_EQ(std::string(head.data(), head.size()), "\x89PNG\r\n\x1a\n");
}

TEST(Chart, RefusesSeriesThatDoNotFitTogetherAndPathsThatCannotBeWritten) {
  Chart chart;
  chart.series = {{"", {1, 2}, {1}}};
  EXPECT_THROW(render(chart), ContractError);
  chart.series = {{"", {1}, {1}, {{1, 1}, {2, 2}}}};
  EXPECT_THROW(render(chart), ContractError);
  const TemporaryFolder folder;
  EXPECT_THROW(render_svg(three_series(), folder / "missing/chart.svg"), OutputError);
  EXPECT_THROW(render_png(three_series(), folder / "missing/chart.png"), OutputError);
}

}  // namespace
}  // namespace furnas
