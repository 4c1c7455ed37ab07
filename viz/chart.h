#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "viz/palette.h"
#include "viz/pixels.h"

namespace furnas {

/// Texts of charts may lower and raise letters: "F_n", "10^{-4}".

/// One axis of a chart.
struct ChartAxis {
  std::string title;                ///< what, and its unit
  bool logarithmic = false;         ///< values that are not positive are left out
  std::optional<double> low, high;  ///< its ends; so that it holds all data if absent
};

/// How the points of a series are joined.
enum class LineStyle { none, solid, dashed, dotted };

/// What stands at each point of a series.
enum class Marker { none, circle, square, diamond, triangle, wedge, cross, plus };

/// How far an error bar reaches along y, from its point.
struct Bar {
  double below{}, above{};
};

/// Points that belong together. Points with a coordinate that is not a number, or that a logarithmic axis
/// cannot show, are left out and interrupt the line.
struct Series {
  std::string name{};            ///< in the legend; empty: not there
  std::vector<double> x{}, y{};  ///< of equal length
  std::vector<Bar> bars{};       ///< error bars; empty: none
  Colour colour = black;
  LineStyle line = LineStyle::solid;
  Marker marker = Marker::none;
  std::vector<bool> open{};  ///< markers that are drawn hollow, for points to be doubted; empty: none
};

/// The outline of a histogram: n + 1 edges of bins, n heights. On a logarithmic axis an empty bin is a gap.
Series steps(std::string name, const std::vector<double>& edges, const std::vector<double>& heights,
             const Colour& colour, LineStyle line = LineStyle::solid);

/// Words beside a point of the data; the chart finds a place for them where they cover no other words.
struct ChartNote {
  double x{}, y{};
  std::string text;
};

/// Where the legend stands.
enum class LegendPlace { automatic, none, top_left, top_right, bottom_left, bottom_right, outside };

/// A diagram of y against x, for paper: black frame and text on white.
struct Chart {
  std::string title;  ///< above; empty: none
  ChartAxis x, y;
  std::vector<Series> series;  ///< later ones are drawn over earlier ones
  std::vector<ChartNote> notes;
  /// `automatic` takes an empty corner, or makes room above the data if a little is enough and `y.high` is
  /// free, or else takes `outside`, right of the frame. Without names there is no legend.
  LegendPlace legend = LegendPlace::automatic;
  int width = 1200;  ///< [pixels]
  int height = 900;  ///< [pixels]
};

/// The chart in pixels, smooth-edged. Needs no display. Throws InputError when there is no OpenGL or no such
/// size, ContractError when x, y, bars and open of a series differ in length or the ends of an axis are
/// in disorder.
Pixels render(const Chart& chart);

/// render, to a PNG file; throws OutputError when the file cannot be written.
void render_png(const Chart& chart, const std::filesystem::path& path);

/// The same picture as lines and text that can be edited; throws OutputError when it cannot be written.
void render_svg(const Chart& chart, const std::filesystem::path& path);

}  // namespace furnas
