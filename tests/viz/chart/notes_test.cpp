#include "viz/chart/notes.h"

#include <gtest/gtest.h>

#include <random>

namespace furnas {
namespace {

Chart chart_with_notes(std::size_t count) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> place(0, 1);
  Chart chart;
  Series s;
  s.marker = Marker::circle;
  s.line = LineStyle::none;
  for (std::size_t k = 0; k < count; ++k) {
    // Two thirds of them in a corner, where they cannot all stand beside their points.
    const double part = k % 3 == 0 ? 1 : 0.1;
    s.x.push_back(part * place(random));
    s.y.push_back(part * place(random));
    s.bars.push_back({0.05, 0.05});
    chart.notes.push_back({s.x.back(), s.y.back(), "time step " + std::to_string(k)});
  }
  chart.series = {s};
  return chart;
}

bool share_room(const Box& a, const Box& b) {
  return a.left < b.right && b.left < a.right && a.bottom < b.top && b.bottom < a.top;
}

TEST(ChartNotes, StandInTheFrameAndCoverNoOther) {
  const Chart chart = chart_with_notes(36);
  const ChartLayout layout = layout_of(chart);
  const std::vector<PlacedNote> notes = place_notes(chart, layout);
  ASSERT_EQ(notes.size(), 36u);
  std::size_t led = 0;
  for (std::size_t k = 0; k < notes.size(); ++k) {
    const Box& box = notes[k].box;
    EXPECT_GT(box.right, box.left) << k;
    EXPECT_GT(box.left, layout.frame.left);
    EXPECT_LT(box.right, layout.frame.right);
    EXPECT_GT(box.bottom, layout.frame.bottom);
    EXPECT_LT(box.top, layout.frame.top);
    for (std::size_t n = 0; n < k; ++n) EXPECT_FALSE(share_room(box, notes[n].box)) << k << " and " << n;
    led += notes[k].led;
  }
  EXPECT_GT(led, 0u) << "where points crowd a line leads to some of them";
}

TEST(ChartNotes, StandBesideAPointThatIsAlone) {
  Chart chart = chart_with_notes(1);
  const ChartLayout layout = layout_of(chart);
  const PlacedNote note = place_notes(chart, layout).front();
  EXPECT_FALSE(note.led);
  EXPECT_FALSE(
      share_room(note.box, {note.point.x - 1, note.point.y - 1, note.point.x + 1, note.point.y + 1}));
}

TEST(ChartNotes, OfPointsThatCannotBeShownHaveNoPlace) {
  Chart chart = chart_with_notes(2);
  chart.y.logarithmic = true;
  chart.notes[1].y = 0;
  const std::vector<PlacedNote> notes = place_notes(chart, layout_of(chart));
  EXPECT_GT(notes[0].box.right, notes[0].box.left);
  EXPECT_EQ(notes[1].box.right, notes[1].box.left);
}

}  // namespace
}  // namespace furnas
