#include "viz/chart/svg_canvas.h"

#include <fmt/format.h>

#include <cmath>

#include "viz/chart/font.h"

namespace furnas {
namespace {

std::string hex(const Colour& colour) {
  const auto byte = [](double part) { return static_cast<int>(std::lround(255 * part)); };
  return fmt::format("#{:02x}{:02x}{:02x}", byte(colour[0]), byte(colour[1]), byte(colour[2]));
}

std::string escaped(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    if (c == '&')
      safe += "&amp;";
    else if (c == '<')
      safe += "&lt;";
    else if (c == '>')
      safe += "&gt;";
    else
      safe += c;
  }
  return safe;
}

}  // namespace

SvgCanvas::SvgCanvas(int width, int height) : width_(width), height_(height) {}

std::string SvgCanvas::points(const std::vector<Spot>& line) const {
  std::string text;
  for (const Spot& p : line)
    text += fmt::format("{}{:.2f},{:.2f}", text.empty() ? "" : " ", p.x, height_ - p.y);
  return text;
}

void SvgCanvas::line(const std::vector<Spot>& corners, const Colour& colour, double width) {
  if (corners.size() < 2) return;
  body_ += fmt::format("<polyline points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{:.2f}\"/>\n",
                       points(corners), hex(colour), width);
}

void SvgCanvas::area(const std::vector<Spot>& outline, const Colour& colour) {
  body_ += fmt::format("<polygon points=\"{}\" fill=\"{}\"/>\n", points(outline), hex(colour));
}

void SvgCanvas::text(const Spot& left, const std::string& text, double size, bool upwards) {
  body_ += fmt::format(
      "<text font-size=\"{:.2f}\" transform=\"translate({:.2f} {:.2f}){}\" "
      "xml:space=\"preserve\">{}</text>\n",
      size, left.x, height_ - left.y, upwards ? " rotate(-90)" : "", escaped(text));
}

void SvgCanvas::clip(const std::optional<Box>& box) {
  if (clipping_) body_ += "</g>\n";
  clipping_ = box.has_value();
  if (!box) return;
  ++clips_;
  body_ += fmt::format(
      "<clipPath id=\"clip{}\"><rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" "
      "height=\"{:.2f}\"/></clipPath>\n"
      "<g clip-path=\"url(#clip{})\">\n",
      clips_, box->left, height_ - box->top, box->right - box->left, box->top - box->bottom, clips_);
}

std::string SvgCanvas::file() const {
  return fmt::format(
             "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
             "font-family=\"{2}, Arial, sans-serif\" stroke-linejoin=\"round\">\n"
             "<rect width=\"{0}\" height=\"{1}\" fill=\"{3}\"/>\n",
             width_, height_, font_name, hex(background_colour)) +
         body_ + (clipping_ ? "</g>\n" : "") + "</svg>\n";
}

}  // namespace furnas
