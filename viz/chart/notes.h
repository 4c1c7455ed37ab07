#pragma once

#include <vector>

#include "viz/chart/layout.h"

namespace furnas {

/// Where a note stands.
struct PlacedNote {
  Box box;           ///< of its words
  Spot point;        ///< what it is about
  bool led = false;  ///< so far away that a thin line leads to it
};

/// A place for each note that can be shown, in their order, beside its point: inside the frame, apart from
/// the other notes, the legend and, as far as there is room, from markers and error bars. Those that cannot
/// be shown have an empty box.
std::vector<PlacedNote> place_notes(const Chart& chart, const ChartLayout& layout);

/// Height of the letters of notes [pixels].
double size_of_notes(const Chart& chart);

}  // namespace furnas
