#pragma once

#include <optional>
#include <string>
#include <vector>

#include "viz/palette.h"

namespace furnas {

/// A place on a canvas [pixels from its bottom left corner].
struct Spot {
  double x{}, y{};
};

/// A rectangle on a canvas [pixels from its bottom left corner].
struct Box {
  double left{}, bottom{}, right{}, top{};
};

/// How a line of text lies at its place: which end or edge of it stands there.
struct TextPlace {
  enum class Across { left, centre, right } across = Across::centre;
  enum class Along { bottom, centre, top } along = Along::centre;
  bool upwards = false;  ///< read from below to above, turned about its place
};

/// What charts are drawn on, black or coloured on white. Lengths in pixels.
class Canvas {
 public:
  Canvas() = default;
  virtual ~Canvas() = default;
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;

  virtual void line(const std::vector<Spot>& corners, const Colour& colour, double width) = 0;
  virtual void area(const std::vector<Spot>& outline, const Colour& colour) = 0;
  /// Black; `size` is that of the font.
  virtual void text(const Spot& spot, const std::string& text, double size, const TextPlace& place) = 0;
  /// From now on nothing is drawn outside the box; nothing: everywhere.
  virtual void clip(const std::optional<Box>& box) = 0;
};

}  // namespace furnas
