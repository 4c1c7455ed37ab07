#pragma once

#include <vector>

#include "viz/chart/layout.h"

namespace furnas {

/// The position of a note.
struct PlacedNote {
  Box box;           ///< of its text
  Spot point;        ///< the point that the note belongs to
  bool led = false;  ///< so far from the point that a thin line joins both
};

/// Finds a place for each note, in their order, beside its point. The place is inside the frame, does not
/// overlap other notes or the legend and, as far as there is room, covers no markers or error bars. Notes
/// that cannot be shown get an empty box.
std::vector<PlacedNote> place_notes(const Chart& chart, const ChartLayout& layout);

/// Height of the letters of notes [pixels].
double size_of_notes(const Chart& chart);

}  // namespace furnas
