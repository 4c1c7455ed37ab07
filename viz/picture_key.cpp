#include "viz/picture_key.h"

#include <algorithm>
#include <cmath>

#include "viz/chart/pixel_canvas.h"
#include "viz/chart/text.h"
#include "viz/chart/ticks.h"

namespace furnas {
namespace {

using Across = TextPlace::Across;
using Along = TextPlace::Along;

constexpr double least_letters = 8;  // [pixels]
constexpr double strip = 4.6;        // height of the strip in heights of letters

double letters_of(int width) { return 0.019 * width; }

Colour colour_of(const Rgb& rgb) { return {rgb[0] / 255.0, rgb[1] / 255.0, rgb[2] / 255.0}; }

void fill(Canvas& canvas, const Box& box, const Colour& colour) {
  canvas.area({{box.left, box.bottom}, {box.right, box.bottom}, {box.right, box.top}, {box.left, box.top}},
              colour);
}

/// Draws a bar of the colours, with values below and a title above.
void draw_scale(Canvas& canvas, const ColourKey& key, int width, double letters) {
  const ColourScale& scale = *key.scale;
  const Box bar{0.15 * width, 1.7 * letters, 0.85 * width, 2.6 * letters};
  constexpr int shades = 256;
  const double shade = (bar.right - bar.left) / shades;
  for (int n = 0; n < shades; ++n)
    fill(canvas,
         {bar.left + n * shade, bar.bottom, std::min(bar.left + (n + 1.5) * shade, bar.right), bar.top},
         colour_of(graded((n + 0.5) / shades)));
  canvas.line({{bar.left, bar.bottom},
               {bar.right, bar.bottom},
               {bar.right, bar.top},
               {bar.left, bar.top},
               {bar.left, bar.bottom}},
              black, 0.06 * letters);

  const Stretch stretch = scale.logarithmic ? Stretch{std::log10(scale.low), std::log10(scale.high)}
                                            : Stretch{scale.low, scale.high};
  const auto ticks = scale.logarithmic ? logarithmic_ticks(stretch, 5) : linear_ticks(stretch, 7);
  for (const Tick& tick : ticks) {
    const double x =
        bar.left + (tick.at - stretch.low) / (stretch.high - stretch.low) * (bar.right - bar.left);
    canvas.line({{x, bar.bottom}, {x, bar.bottom - (tick.label.empty() ? 0.15 : 0.3) * letters}}, black,
                0.06 * letters);
    write(canvas, {x, 1.25 * letters}, tick.label, letters, {Across::centre, Along::top});
  }
  write(canvas, {0.5 * width, 3.1 * letters}, key.title, letters, {Across::centre, Along::bottom});
}

/// Draws a square and a word for each colour, all in a row.
void draw_words(Canvas& canvas, const ColourKey& key, int width, double letters) {
  const double gap = 0.5 * letters, between = 2 * letters;
  double length = -between;
  for (const ColourKey::Word& word : key.words)
    length += letters + gap + width_of_text(word.text, letters) + between;
  double x = 0.5 * (width - length);
  const double y = 0.5 * strip * letters;
  for (const ColourKey::Word& word : key.words) {
    fill(canvas, {x, y - 0.5 * letters, x + letters, y + 0.5 * letters}, colour_of(word.colour));
    x += letters + gap;
    write(canvas, {x, y}, word.text, letters, {Across::left, Along::centre});
    x += width_of_text(word.text, letters) + between;
  }
}

}  // namespace

int height_of_key(int width) {
  const double letters = letters_of(width);
  return letters < least_letters ? 0 : static_cast<int>(std::ceil(strip * letters));
}

Pixels drawn_key(const ColourKey& key, int width) {
  const double letters = letters_of(width);
  return painted(width, height_of_key(width), [&](Canvas& canvas) {
    key.scale ? draw_scale(canvas, key, width, letters) : draw_words(canvas, key, width, letters);
  });
}

}  // namespace furnas
