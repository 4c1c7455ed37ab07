#pragma once

#include <optional>
#include <string>
#include <vector>

#include "viz/palette.h"

namespace furnas {

/// A position on a canvas [pixels from its bottom left corner].
struct Spot {
  double x{}, y{};
};

/// A rectangle on a canvas [pixels from its bottom left corner].
struct Box {
  double left{}, bottom{}, right{}, top{};
};

/// A surface on which charts are drawn, black or coloured on white. Lengths are in pixels.
class Canvas {
 public:
  Canvas() = default;
  virtual ~Canvas() = default;
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;

  /// Draws a line through the corners in their order.
  virtual void line(const std::vector<Spot>& corners, const Colour& colour, double width) = 0;
  /// Fills an area; its outline may be clockwise or counterclockwise.
  virtual void area(const std::vector<Spot>& outline, const Colour& colour) = 0;
  /// Writes black text. `left` is the left end of the baseline; `upwards`: the text runs from bottom to top.
  virtual void text(const Spot& left, const std::string& text, double size, bool upwards) = 0;
  /// Restricts all further drawing to the box; without a box there is no restriction.
  virtual void clip(const std::optional<Box>& box) = 0;
};

}  // namespace furnas
