#pragma once

#include <string>
#include <vector>

#include "viz/chart/canvas.h"

namespace furnas {

/// The position of a line of text relative to its point.
struct TextPlace {
  enum class Across { left, centre, right } across = Across::centre;
  enum class Along { bottom, centre, top } along = Along::centre;  ///< part of a capital letter at the point
  bool upwards = false;  ///< text runs from bottom to top, rotated about its point
};

/// A part of a text with letters of one size at one height.
struct TextRun {
  std::string text;
  double size = 1;  ///< font size, as a share of that of the text
  double lift = 0;  ///< height above the baseline, as a share of the size of the text
  friend bool operator==(const TextRun&, const TextRun&) = default;
};

/// Splits texts such as "F_n" and "10^{-4}" into runs: _ lowers and ^ raises the next letter, or the letters
/// in braces.
std::vector<TextRun> text_runs(const std::string& text);

/// Width of such a text [pixels].
double width_of_text(const std::string& text, double size);

/// Writes such a text.
void write(Canvas& canvas, const Spot& spot, const std::string& text, double size, const TextPlace& place);

}  // namespace furnas
