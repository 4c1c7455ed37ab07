#include "viz/chart/notes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "viz/chart/text.h"

namespace furnas {
namespace {

bool overlap(const Box& a, const Box& b, double gap) {
  return a.left < b.right + gap && b.left < a.right + gap && a.bottom < b.top + gap && b.bottom < a.top + gap;
}

bool lies_within(const Box& box, const Box& frame, double gap) {
  return box.left > frame.left + gap && box.right < frame.right - gap && box.bottom > frame.bottom + gap &&
         box.top < frame.top - gap;
}

class NotePlacing {
 public:
  NotePlacing(const Chart& chart, const ChartLayout& layout)
      : chart_(chart), layout_(layout), size_(sizes_of(chart)), height_(size_of_notes(chart)) {
    for (const Series& s : chart.series)
      if (s.marker != Marker::none)
        for (std::size_t k = 0; k < s.x.size(); ++k) add_ink(s, k);
  }

  std::vector<PlacedNote> place() {
    std::vector<PlacedNote> placed;
    for (const ChartNote& note : chart_.notes) placed.push_back(place(note));
    return placed;
  }

 private:
  Spot spot(double x, double y) const { return spot_of(chart_, layout_, x, y); }

  /// Adds a marker, and points along its error bar, to the points that notes should not cover.
  void add_ink(const Series& s, std::size_t k) {
    const Spot at = spot(s.x[k], s.y[k]);
    if (!finite(at)) return;
    markers_.push_back(at);
    if (s.bars.empty()) return;
    const Spot high = spot(s.x[k], s.y[k] + s.bars[k].above), low = spot(s.x[k], s.y[k] - s.bars[k].below);
    const double bottom = finite(low) ? low.y : layout_.frame.bottom;
    for (double y = bottom; y <= high.y; y += 0.3 * height_) bars_.push_back({at.x, y});
  }

  /// The box of a text beside the point `place`, in the direction `way` from the point of the note.
  Box box_at(const Spot& place, const Spot& way, double width) const {
    const double left = place.x + (way.x - 1) / 2 * width, bottom = place.y + (way.y - 1) / 2 * height_;
    return {left, bottom, left + width, bottom + height_};
  }

  /// The cost of a place for a note; infinite if the place is not allowed.
  double cost(const Box& box, double away) const {
    const double gap = 0.3 * height_;
    if (!lies_within(box, layout_.frame, gap)) return std::numeric_limits<double>::infinity();
    if (layout_.legend.right > layout_.legend.left && overlap(box, layout_.legend, gap))
      return std::numeric_limits<double>::infinity();
    for (const Box& other : taken_)
      if (overlap(box, other, gap)) return std::numeric_limits<double>::infinity();
    const double markers = static_cast<double>(covered(box, markers_, 0.6 * size_.marker));
    const double bars = static_cast<double>(covered(box, bars_, 0.1 * height_));
    return away / height_ + 20 * markers + 3 * bars;
  }

  PlacedNote place(const ChartNote& note) {
    PlacedNote best;
    best.point = spot(note.x, note.y);
    if (!finite(best.point)) return best;
    const double width = width_of_text(note.text, height_);
    double least = std::numeric_limits<double>::infinity();
    constexpr int ways = 16;
    const double near = 0.9 * size_.marker;
    const double farthest =
        std::hypot(layout_.frame.right - layout_.frame.left, layout_.frame.top - layout_.frame.bottom);
    // Places on rings around the point are tried, beginning with the smallest ring. The search ends when the
    // cost of the distance alone exceeds the lowest cost found.
    for (double away = near; away < farthest && away / height_ < least; away *= 1.3)
      for (int n = 0; n < ways; ++n) {
        const double angle = 2 * std::numbers::pi * n / ways;
        const Spot way{std::cos(angle), std::sin(angle)};
        const Box box = box_at({best.point.x + away * way.x, best.point.y + away * way.y}, way, width);
        const double is = cost(box, away);
        if (is >= least) continue;
        least = is;
        best.box = box;
        best.led = away > 2.5 * near;
      }
    if (best.box.right > best.box.left) taken_.push_back(best.box);
    return best;
  }

  const Chart& chart_;
  const ChartLayout& layout_;
  const ChartSizes size_;
  const double height_;
  std::vector<Spot> markers_, bars_;
  std::vector<Box> taken_;
};

}  // namespace

double size_of_notes(const Chart& chart) { return 0.62 * sizes_of(chart).label; }

std::vector<PlacedNote> place_notes(const Chart& chart, const ChartLayout& layout) {
  return NotePlacing(chart, layout).place();
}

}  // namespace furnas
