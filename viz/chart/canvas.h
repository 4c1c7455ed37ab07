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

/// What charts are drawn on, black or coloured on white. Lengths in pixels.
class Canvas {
 public:
  Canvas() = default;
  virtual ~Canvas() = default;
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;

  /// Through the corners in their order.
  virtual void line(const std::vector<Spot>& corners, const Colour& colour, double width) = 0;
  /// Filled, whatever the sense of its outline.
  virtual void area(const std::vector<Spot>& outline, const Colour& colour) = 0;
  /// Black. `left` is where the first letter begins and what it stands on; upwards: read from below to above.
  virtual void text(const Spot& left, const std::string& text, double size, bool upwards) = 0;
  /// From now on nothing is drawn outside the box; nothing: everywhere.
  virtual void clip(const std::optional<Box>& box) = 0;
};

}  // namespace furnas
