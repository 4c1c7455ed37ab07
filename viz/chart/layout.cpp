#include "viz/chart/layout.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "engine/base/require.h"
#include "viz/chart/text.h"

namespace furnas {
namespace {

constexpr int most_x_labels = 8, most_y_labels = 8;

/// Computes the stretch of an axis from all values that can be shown. Without values it is [0, 1], or one
/// power of ten around 1 on a logarithmic axis.
class Extent {
 public:
  explicit Extent(const ChartAxis& axis) : axis_(axis) {}
  void add(double value) {
    const double at = shown(axis_, value);
    if (!std::isfinite(at)) return;
    low_ = std::min(low_, at);
    high_ = std::max(high_, at);
  }

  /// The stretch with the ends that are given for the axis. Other ends leave free space beside the data,
  /// `headroom` times the range of the data, and are moved outwards to the next mark.
  Stretch stretch(int most, double headroom) const {
    Stretch s{low_, high_};
    if (!(s.low <= s.high)) s = {0, axis_.logarithmic ? 0.0 : 1.0};
    if (axis_.low) s.low = shown(axis_, *axis_.low);
    if (axis_.high) s.high = shown(axis_, *axis_.high);
    require(std::isfinite(s.low) && std::isfinite(s.high), "the ends of an axis can be shown on it");
    require(!axis_.low || !axis_.high || s.low < s.high, "the ends of an axis are in order");
    const double room = headroom * std::max(0.0, s.high - s.low);
    if (!axis_.high) s.high += room;
    // The lower end of a linear axis gets no free space, so that an axis that begins at 0 still does.
    if (!axis_.low && axis_.logarithmic) s.low -= room;
    if (!(s.high - s.low > 1e-12 * std::max(std::abs(s.low), std::abs(s.high)))) {
      const double half = axis_.logarithmic || s.low == 0 ? 0.5 : 0.1 * std::abs(s.low);
      if (!axis_.low) s.low -= half;
      s.high += half;
    }
    const Stretch wide = axis_.logarithmic ? decades(s) : widened_to_ticks(s, most);
    return {axis_.low ? s.low : wide.low, axis_.high ? s.high : wide.high};
  }

 private:
  /// Widens the stretch to the next 1, 2 or 5 times a power of ten.
  static Stretch decades(const Stretch& s) {
    const auto round = [](double at, bool up) {
      constexpr double steps[] = {0, 0.30102999566398120, 0.69897000433601880, 1};
      const double whole = std::floor(at + 1e-9), part = at - whole;
      if (up)
        return whole +
               *std::find_if(std::begin(steps), std::end(steps), [&](double x) { return x >= part - 1e-9; });
      return whole +
             *std::find_if(std::rbegin(steps), std::rend(steps), [&](double x) { return x <= part + 1e-9; });
    };
    return {round(s.low, false), round(s.high, true)};
  }

  const ChartAxis& axis_;
  double low_ = std::numeric_limits<double>::infinity();
  double high_ = -std::numeric_limits<double>::infinity();
};

void find_stretches(const Chart& chart, ChartLayout& layout) {
  Extent x(chart.x), y(chart.y);
  for (const Series& s : chart.series) {
    require(s.x.size() == s.y.size() && (s.bars.empty() || s.bars.size() == s.y.size()) &&
                (s.open.empty() || s.open.size() == s.y.size()),
            "x, y, bars and open of a series have the same length");
    for (std::size_t k = 0; k < s.x.size(); ++k) {
      if (!std::isfinite(shown(chart.x, s.x[k])) || !std::isfinite(shown(chart.y, s.y[k]))) continue;
      x.add(s.x[k]);
      y.add(s.y[k]);
      if (s.bars.empty()) continue;
      y.add(s.y[k] + s.bars[k].above);
      if (!chart.y.logarithmic) y.add(s.y[k] - s.bars[k].below);
    }
  }
  layout.x = x.stretch(most_x_labels, 0);
  layout.y = y.stretch(most_y_labels, 0.02);
}

std::vector<Tick> ticks_of(const ChartAxis& axis, const Stretch& stretch, int most) {
  return axis.logarithmic ? logarithmic_ticks(stretch, most) : linear_ticks(stretch, most);
}

double widest(const std::vector<Tick>& ticks, double size) {
  double most = 0;
  for (const Tick& tick : ticks) most = std::max(most, width_of_text(tick.label, size));
  return most;
}

/// Computes the marks, and the frame with room for their numbers and for the titles.
void place_frame(const Chart& chart, ChartLayout& layout) {
  layout.x_ticks = ticks_of(chart.x, layout.x, most_x_labels);
  layout.y_ticks = ticks_of(chart.y, layout.y, most_y_labels);
  const ChartSizes size = sizes_of(chart);
  Box& frame = layout.frame;
  frame.left = 2 * size.gap + (chart.y.title.empty() ? 0 : 1.4 * size.title) + size.gap +
               widest(layout.y_ticks, size.label);
  frame.bottom = 2 * size.gap + (chart.x.title.empty() ? 0 : 1.4 * size.title) + size.label + 0.4 * size.gap;
  // Half of the last number on the x axis extends beyond the frame.
  frame.right = chart.width - size.gap - 0.5 * widest(layout.x_ticks, size.label);
  frame.top = chart.height - 1.5 * size.gap - (chart.title.empty() ? 0 : 1.6 * size.title);
}

/// Points along everything that is drawn, so dense that no part of it lies unnoticed in a box [pixels].
std::vector<Spot> ink(const Chart& chart, const ChartLayout& layout) {
  constexpr int between = 24;
  const auto place = [&](const Series& s, std::size_t k, double way) {
    return spot_of(chart, layout, s.x[k], s.y[k] + way);
  };
  std::vector<Spot> points;
  for (const Series& s : chart.series)
    for (std::size_t k = 0; k < s.x.size(); ++k) {
      const auto here = place(s, k, 0);
      points.push_back(here);
      const auto join = [&](const Spot& there) {
        for (int n = 1; n < between; ++n) {
          const double t = double(n) / between;
          points.push_back({here.x + t * (there.x - here.x), here.y + t * (there.y - here.y)});
        }
      };
      if (s.line != LineStyle::none && k + 1 < s.x.size()) join(place(s, k + 1, 0));
      if (!s.bars.empty()) join(place(s, k, s.bars[k].above)), join(place(s, k, -s.bars[k].below));
    }
  return points;
}

Box corner(const Box& frame, LegendPlace place, const std::array<double, 2>& size, double gap) {
  const bool right = place == LegendPlace::top_right || place == LegendPlace::bottom_right;
  const bool top = place == LegendPlace::top_right || place == LegendPlace::top_left;
  const double left = right ? frame.right - gap - size[0] : frame.left + gap;
  const double bottom = top ? frame.top - gap - size[1] : frame.bottom + gap;
  return {left, bottom, left + size[0], bottom + size[1]};
}

/// Width and height of the legend; nothing if there is no legend.
std::optional<std::array<double, 2>> legend_size(const Chart& chart) {
  const ChartSizes size = sizes_of(chart);
  double widest_name = 0, names = 0;
  for (const Series& s : chart.series) {
    if (s.name.empty()) continue;
    widest_name = std::max(widest_name, width_of_text(s.name, size.label));
    ++names;
  }
  if (names == 0 || chart.legend == LegendPlace::none) return {};
  return {{widest_name + size.symbol + 3 * size.gap, names * size.row + size.gap}};
}

struct Choice {
  LegendPlace place;
  std::size_t covered;  ///< number of covered points of the data
};

Choice emptiest(const Chart& chart, const ChartLayout& layout, const std::array<double, 2>& size,
                double gap) {
  Choice best{LegendPlace::top_right, std::numeric_limits<std::size_t>::max()};
  const auto points = ink(chart, layout);
  for (const LegendPlace place :
       {LegendPlace::top_right, LegendPlace::top_left, LegendPlace::bottom_right, LegendPlace::bottom_left}) {
    const std::size_t count = covered(corner(layout.frame, place, size, gap), points, 1.5 * gap);
    if (count < best.covered) best = {place, count};
  }
  return best;
}

/// Finds an empty corner for the legend. If none is empty and the upper end of the y axis is not given, the
/// axis is extended until a corner is empty, but only as far as the data keep two thirds of it. Otherwise the
/// legend is placed right of the frame.
LegendPlace find_place(const Chart& chart, const std::array<double, 2>& size, ChartLayout& layout) {
  if (chart.legend != LegendPlace::automatic) return chart.legend;
  const double gap = sizes_of(chart).gap;
  constexpr int raises = 6;
  constexpr double most = 0.5;  // largest extension, as a share of the axis without it
  const double top = layout.y.high, room = most * (top - layout.y.low);
  for (int n = 0; n <= (chart.y.high ? 0 : raises); ++n) {
    layout.y.high = top + room * n / raises;
    if (const Choice best = emptiest(chart, layout, size, gap); best.covered == 0) return best.place;
  }
  layout.y.high = top;
  return LegendPlace::outside;
}

}  // namespace

double ChartLayout::along_x(double coordinate) const {
  return frame.left + (coordinate - x.low) / (x.high - x.low) * (frame.right - frame.left);
}

double ChartLayout::along_y(double coordinate) const {
  return frame.bottom + (coordinate - y.low) / (y.high - y.low) * (frame.top - frame.bottom);
}

Spot spot_of(const Chart& chart, const ChartLayout& layout, double x, double y) {
  return {layout.along_x(shown(chart.x, x)), layout.along_y(shown(chart.y, y))};
}

bool finite(const Spot& spot) { return std::isfinite(spot.x) && std::isfinite(spot.y); }

std::size_t covered(const Box& box, const std::vector<Spot>& spots, double gap) {
  return static_cast<std::size_t>(std::count_if(spots.begin(), spots.end(), [&](const Spot& p) {
    return p.x > box.left - gap && p.x < box.right + gap && p.y > box.bottom - gap && p.y < box.top + gap;
  }));
}

double shown(const ChartAxis& axis, double value) {
  if (!axis.logarithmic) return std::isfinite(value) ? value : std::numeric_limits<double>::quiet_NaN();
  return value > 0 && std::isfinite(value) ? std::log10(value) : std::numeric_limits<double>::quiet_NaN();
}

ChartSizes sizes_of(const Chart& chart) {
  const double unit = std::min(chart.width / 100.0, chart.height / 75.0);
  ChartSizes size;
  size.label = 2.4 * unit;
  size.title = 2.7 * unit;
  size.gap = 1.2 * unit;
  size.symbol = 5 * unit;
  size.row = 1.5 * size.label;
  size.line = 0.25 * unit;
  size.marker = 1.1 * unit;
  return size;
}

ChartLayout layout_of(const Chart& chart) {
  ChartLayout layout;
  find_stretches(chart, layout);
  place_frame(chart, layout);
  if (const auto size = legend_size(chart)) {
    const LegendPlace place = find_place(chart, *size, layout);
    const double gap = sizes_of(chart).gap;
    place_frame(chart, layout);
    Box& frame = layout.frame;
    if (place == LegendPlace::outside) {
      frame.right = chart.width - size->front() - gap;
      layout.legend = {frame.right + 0.5 * gap, frame.top - size->back(),
                       frame.right + 0.5 * gap + size->front(), frame.top};
    } else {
      layout.legend = corner(frame, place, *size, gap);
    }
  }
  return layout;
}

}  // namespace furnas
