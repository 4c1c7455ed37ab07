#pragma once

#include <string>

#include "viz/chart/canvas.h"

namespace furnas {

/// Writes what is drawn as SVG, with text that can be searched and edited.
class SvgCanvas final : public Canvas {
 public:
  SvgCanvas(int width, int height);

  void line(const std::vector<Spot>& corners, const Colour& colour, double width) override;
  void area(const std::vector<Spot>& outline, const Colour& colour) override;
  void text(const Spot& left, const std::string& text, double size, bool upwards) override;
  void clip(const std::optional<Box>& box) override;

  /// The content of the SVG file.
  std::string file() const;

 private:
  std::string points(const std::vector<Spot>& line) const;

  int width_, height_;
  int clips_ = 0;
  bool clipping_ = false;
  std::string body_;
};

}  // namespace furnas
