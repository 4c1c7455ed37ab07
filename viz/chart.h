#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "viz/palette.h"
#include "viz/pixels.h"

namespace furnas {

/// Texts of charts may contain subscripts and superscripts: "F_n", "10^{-4}".

/// One axis of a chart.
struct ChartAxis {
  std::string title;                ///< the quantity and its unit
  bool logarithmic = false;         ///< values that are not positive are left out
  std::optional<double> low, high;  ///< its ends; if absent, chosen to include all data
};

/// How the points of a series are joined.
enum class LineStyle { none, solid, dashed, dotted };

/// The marker at each point of a series.
enum class Marker { none, circle, square, diamond, triangle, wedge, cross, plus };

/// Lengths of an error bar along y, measured from its point.
struct Bar {
  double below{}, above{};
};

/// Points that belong together. Points with a coordinate that is not a number, or that a logarithmic axis
/// cannot show, are left out and interrupt the line.
struct Series {
  std::string name{};            ///< in the legend; empty: not in the legend
  std::vector<double> x{}, y{};  ///< of equal length
  std::vector<Bar> bars{};       ///< error bars; empty: none
  Colour colour = black;
  LineStyle line = LineStyle::solid;
  Marker marker = Marker::none;
  std::vector<bool> open{};  ///< which markers are drawn hollow, for uncertain points; empty: none
};

/// The outline of a histogram with n + 1 edges of bins and n heights. On a logarithmic axis an empty bin is a
/// gap.
Series steps(std::string name, const std::vector<double>& edges, const std::vector<double>& heights,
             const Colour& colour, LineStyle line = LineStyle::solid);

/// A text beside a point of the data; the chart places it where it covers no other text.
struct ChartNote {
  double x{}, y{};
  std::string text;
};

/// The place of the legend.
enum class LegendPlace { automatic, none, top_left, top_right, bottom_left, bottom_right, outside };

/// A diagram of y against x, for print: black frame and text on white.
struct Chart {
  std::string title;  ///< above the frame; empty: none
  ChartAxis x, y;
  std::vector<Series> series;  ///< later ones are drawn over earlier ones
  std::vector<ChartNote> notes;
  /// `automatic` uses an empty corner. If there is none and `y.high` is not given, the y axis is extended, up
  /// to 1.5 times the range of the data, until a corner is empty. Otherwise the legend is placed `outside`,
  /// right of the frame. If no series has a name, there is no legend.
  LegendPlace legend = LegendPlace::automatic;
  int width = 1200;  ///< [pixels]
  int height = 900;  ///< [pixels]
};

/// The chart in pixels, with anti-aliasing. Needs no display. Throws InputError when there is no OpenGL or
/// the size is not possible, ContractError when x, y, bars and open of a series differ in length or when the
/// lower end of an axis is not below the upper end.
Pixels render(const Chart& chart);

/// Renders to a PNG file; throws OutputError when the file cannot be written.
void render_png(const Chart& chart, const std::filesystem::path& path);

/// Writes the same picture as an SVG file, whose lines and text can be edited; throws OutputError when the
/// file cannot be written.
void render_svg(const Chart& chart, const std::filesystem::path& path);

}  // namespace furnas
