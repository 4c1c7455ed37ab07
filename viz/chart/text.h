#pragma once

#include <string>
#include <vector>

#include "viz/chart/canvas.h"

namespace furnas {

/// Where a line of text stands at its place.
struct TextPlace {
  enum class Across { left, centre, right } across = Across::centre;
  enum class Along { bottom, centre, top } along = Along::centre;  ///< of capital letters
  bool upwards = false;  ///< read from below to above, turned about its place
};

/// Letters of one size at one height.
struct TextRun {
  std::string text;
  double size = 1;  ///< of the font, as a part of that of the text
  double lift = 0;  ///< above the line, as a part of the size of the text
  friend bool operator==(const TextRun&, const TextRun&) = default;
};

/// Takes "F_n", "10^{-4}" and the like apart: _ lowers and ^ raises the next letter, or what stands in
/// braces.
std::vector<TextRun> text_runs(const std::string& text);

/// Width of such a text [pixels].
double width_of_text(const std::string& text, double size);

/// Writes such a text.
void write(Canvas& canvas, const Spot& spot, const std::string& text, double size, const TextPlace& place);

}  // namespace furnas
