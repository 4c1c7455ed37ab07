#include "viz/chart/drawing.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "viz/chart/layout.h"
#include "viz/chart/notes.h"
#include "viz/chart/text.h"

namespace furnas {
namespace {

using Polyline = std::vector<Spot>;
using Across = TextPlace::Across;
using Along = TextPlace::Along;

/// Lengths of dash and gap of a dashed line [pixels].
struct Dashes {
  double stroke, gap;
};

class ChartDrawing {
 public:
  ChartDrawing(const Chart& chart, Canvas& canvas)
      : chart_(chart), canvas_(canvas), size_(sizes_of(chart)), layout_(layout_of(chart)) {}

  void draw() {
    draw_frame();
    for (const Series& s : chart_.series) {
      canvas_.clip(layout_.frame);
      draw_lines(s);
      canvas_.clip({});
      draw_markers(s);
    }
    draw_titles();
    draw_legend();
    draw_notes();
  }

 private:
  Spot spot(double x, double y) const { return spot_of(chart_, layout_, x, y); }

  /// Draws the dashes of a dashed line; the pattern continues around corners.
  void draw_dashed(const Polyline& line, const Dashes& dashes, const Colour& colour) {
    Polyline stroke;
    bool drawing = true;
    double left = dashes.stroke;
    for (std::size_t k = 0; k + 1 < line.size(); ++k) {
      const Spot &a = line[k], &b = line[k + 1];
      const double length = std::hypot(b.x - a.x, b.y - a.y);
      if (drawing) stroke.push_back(a);
      for (double done = 0; done < length;) {
        const double way = std::min(left, length - done);
        done += way;
        left -= way;
        const Spot here{a.x + (b.x - a.x) * done / length, a.y + (b.y - a.y) * done / length};
        if (drawing) stroke.push_back(here);
        if (left > 0) continue;
        if (drawing) canvas_.line(std::exchange(stroke, {}), colour, size_.line);
        drawing = !drawing;
        left = drawing ? dashes.stroke : dashes.gap;
        if (drawing) stroke.push_back(here);
      }
    }
    canvas_.line(stroke, colour, size_.line);
  }

  void draw_styled(const Polyline& line, const Series& s) {
    if (s.line == LineStyle::solid) canvas_.line(line, s.colour, size_.line);
    if (s.line == LineStyle::dashed) draw_dashed(line, {4 * size_.line, 2.5 * size_.line}, s.colour);
    if (s.line == LineStyle::dotted) draw_dashed(line, {1.2 * size_.line, 1.8 * size_.line}, s.colour);
  }

  /// A regular polygon around a point, with one corner at the angle `turn` from the x axis.
  static Polyline polygon(const Spot& p, int corners, double radius, double turn) {
    Polyline outline;
    for (int n = 0; n < corners; ++n) {
      const double angle = turn + 2 * std::numbers::pi * n / corners;
      outline.push_back({p.x + radius * std::cos(angle), p.y + radius * std::sin(angle)});
    }
    return outline;
  }

  /// Draws a filled polygon, or only its outline.
  void draw_polygon(const Spot& p, int corners, double radius, double turn, const Colour& colour, bool open) {
    canvas_.area(polygon(p, corners, radius, turn), colour);
    if (!open) return;
    const double inner = radius - 0.75 * size_.line / std::cos(std::numbers::pi / corners);
    canvas_.area(polygon(p, corners, inner, turn), background_colour);
  }

  /// Draws a marker. All markers cover about the same area; markers that consist of strokes are never filled.
  void draw_marker(const Spot& p, const Series& s, bool open = false) {
    constexpr double pi = std::numbers::pi;
    const double r = 0.5 * size_.marker, d = 0.9 * r;
    switch (s.marker) {
      case Marker::none:
        return;
      case Marker::circle:
        return draw_polygon(p, 32, r, 0, s.colour, open);
      case Marker::square:
        return draw_polygon(p, 4, 1.25 * r, pi / 4, s.colour, open);
      case Marker::diamond:
        return draw_polygon(p, 4, 1.35 * r, 0, s.colour, open);
      case Marker::triangle:
        return draw_polygon(p, 3, 1.5 * r, pi / 2, s.colour, open);
      case Marker::wedge:
        return draw_polygon(p, 3, 1.5 * r, -pi / 2, s.colour, open);
      case Marker::cross:
        canvas_.line({{p.x - d, p.y - d}, {p.x + d, p.y + d}}, s.colour, size_.line);
        return canvas_.line({{p.x - d, p.y + d}, {p.x + d, p.y - d}}, s.colour, size_.line);
      case Marker::plus:
        canvas_.line({{p.x - d, p.y}, {p.x + d, p.y}}, s.colour, size_.line);
        return canvas_.line({{p.x, p.y - d}, {p.x, p.y + d}}, s.colour, size_.line);
    }
  }

  void draw_error_bar(const Series& s, std::size_t k) {
    const Bar& bar = s.bars[k];
    const Spot high = spot(s.x[k], s.y[k] + bar.above);
    Spot low = spot(s.x[k], s.y[k] - bar.below);
    if (!finite(spot(s.x[k], s.y[k])) || !(bar.below + bar.above > 0) || !finite(high)) return;
    const double cap = 0.4 * size_.marker;
    const auto thin = [&](const Polyline& line) { canvas_.line(line, s.colour, 0.6 * size_.line); };
    thin({{high.x - cap, high.y}, {high.x + cap, high.y}});
    // On a logarithmic axis a bar that reaches zero or less has no lower end.
    if (finite(low))
      thin({{low.x - cap, low.y}, {low.x + cap, low.y}});
    else
      low = {high.x, layout_.frame.bottom};
    thin({low, high});
  }

  void draw_lines(const Series& s) {
    for (std::size_t k = 0; k < s.bars.size(); ++k) draw_error_bar(s, k);
    Polyline line;
    for (std::size_t k = 0; k < s.x.size(); ++k) {
      const Spot p = spot(s.x[k], s.y[k]);
      if (finite(p))
        line.push_back(p);
      else
        draw_styled(std::exchange(line, {}), s);
    }
    draw_styled(line, s);
  }

  /// Draws whole markers, also where they extend beyond the frame.
  void draw_markers(const Series& s) {
    const auto& [left, bottom, right, top] = layout_.frame;
    for (std::size_t k = 0; k < s.x.size(); ++k) {
      const Spot p = spot(s.x[k], s.y[k]);
      if (p.x > left - 1 && p.x < right + 1 && p.y > bottom - 1 && p.y < top + 1)
        draw_marker(p, s, !s.open.empty() && s.open[k]);
    }
  }

  void draw_frame() {
    const auto& [left, bottom, right, top] = layout_.frame;
    const auto thin = [&](const Polyline& line) { canvas_.line(line, black, 0.6 * size_.line); };
    thin({{left, bottom}, {right, bottom}, {right, top}, {left, top}, {left, bottom}});
    for (const Tick& tick : layout_.x_ticks) {
      const double x = layout_.along_x(tick.at), length = size_.gap * (tick.label.empty() ? 0.4 : 0.8);
      thin({{x, bottom}, {x, bottom + length}});
      thin({{x, top}, {x, top - length}});
      write(canvas_, {x, bottom - 1.2 * size_.gap}, tick.label, size_.label, {Across::centre, Along::top});
    }
    for (const Tick& tick : layout_.y_ticks) {
      const double y = layout_.along_y(tick.at), length = size_.gap * (tick.label.empty() ? 0.4 : 0.8);
      thin({{left, y}, {left + length, y}});
      thin({{right, y}, {right - length, y}});
      write(canvas_, {left - 0.8 * size_.gap, y}, tick.label, size_.label, {Across::right, Along::centre});
    }
  }

  void draw_titles() {
    const auto& [left, bottom, right, top] = layout_.frame;
    const double x = (left + right) / 2, y = (bottom + top) / 2;
    write(canvas_, {x, 1.2 * size_.gap}, chart_.x.title, size_.title, {Across::centre, Along::bottom});
    write(canvas_, {size_.gap, y}, chart_.y.title, size_.title, {Across::centre, Along::top, true});
    write(canvas_, {x, top + size_.gap}, chart_.title, size_.title, {Across::centre, Along::bottom});
  }

  void draw_legend() {
    const auto& [left, bottom, right, top] = layout_.legend;
    if (!(right > left)) return;
    canvas_.area({{left, bottom}, {right, bottom}, {right, top}, {left, top}}, background_colour);
    double y = top - 0.5 * size_.gap - 0.5 * size_.row;
    for (const Series& s : chart_.series) {
      if (s.name.empty()) continue;
      const double from = left + size_.gap, to = from + size_.symbol;
      draw_styled({{from, y}, {to, y}}, s);
      const bool all_open = !s.open.empty() && std::find(s.open.begin(), s.open.end(), false) == s.open.end();
      draw_marker({(from + to) / 2, y}, s, all_open);
      write(canvas_, {to + size_.gap, y}, s.name, size_.label, {Across::left, Along::centre});
      y -= size_.row;
    }
  }

  /// Draws the notes, and a line from a distant note to its point.
  void draw_notes() {
    const std::vector<PlacedNote> placed = place_notes(chart_, layout_);
    for (std::size_t k = 0; k < placed.size(); ++k) {
      const auto& [box, point, led] = placed[k];
      if (!(box.right > box.left)) continue;
      const Spot near{std::clamp(point.x, box.left, box.right), std::clamp(point.y, box.bottom, box.top)};
      if (led) canvas_.line({near, point}, large_colour, 0.4 * size_.line);
      write(canvas_, {box.left, box.bottom}, chart_.notes[k].text, size_of_notes(chart_),
            {Across::left, Along::bottom});
    }
  }

  const Chart& chart_;
  Canvas& canvas_;
  ChartSizes size_;
  ChartLayout layout_;
};

}  // namespace

void draw(const Chart& chart, Canvas& canvas) { ChartDrawing(chart, canvas).draw(); }

}  // namespace furnas
