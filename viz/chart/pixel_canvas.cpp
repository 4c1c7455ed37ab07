#include "viz/chart/pixel_canvas.h"

#include <vtkBrush.h>
#include <vtkContext2D.h>
#include <vtkContextActor.h>
#include <vtkContextDevice2D.h>
#include <vtkContextItem.h>
#include <vtkContextScene.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPen.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkStdString.h>
#include <vtkTextProperty.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <exception>
#include <stdexcept>

#include "viz/chart/font.h"
#include "viz/offscreen.h"

namespace furnas {
namespace {

/// Each pixel of the picture is the mean of n x n drawn pixels; n is 3 where OpenGL can draw so many, and
/// smaller for a large picture.
int smoothing_of(int width, int height) {
  constexpr int most_pixels = 16384;  // that OpenGL draws along an edge
  return std::clamp(most_pixels / std::max(width, height), 1, 3);
}

/// Draws with VTK, magnified by the factor `smoothing`.
class PixelCanvas final : public Canvas {
 public:
  PixelCanvas(vtkContext2D& painter, int smoothing) : painter_(painter), smoothing_(smoothing) {
    painter_.GetPen()->SetOpacityF(1);
  }

  void line(const std::vector<Spot>& corners, const Colour& colour, double width) override {
    if (corners.size() < 2) return;
    vtkPen& pen = *painter_.GetPen();
    pen.SetLineType(vtkPen::SOLID_LINE);
    pen.SetColorF(colour[0], colour[1], colour[2]);
    pen.SetWidth(static_cast<float>(smoothing_ * width));
    std::vector<float> numbers = fine(corners);
    painter_.DrawPoly(numbers.data(), static_cast<int>(corners.size()));
  }

  void area(const std::vector<Spot>& outline, const Colour& colour) override {
    painter_.GetPen()->SetLineType(vtkPen::NO_PEN);
    painter_.GetBrush()->SetColorF(colour[0], colour[1], colour[2]);
    painter_.GetBrush()->SetOpacityF(1);
    std::vector<float> numbers = fine(outline);
    painter_.DrawPolygon(numbers.data(), static_cast<int>(outline.size()));
  }

  void text(const Spot& left, const std::string& text, double size, bool upwards) override {
    vtkTextProperty& letters = *painter_.GetTextProp();
    set_font(letters, smoothing_ * size);
    letters.SetJustificationToLeft();
    letters.SetVerticalJustificationToBottom();
    letters.SetOrientation(upwards ? 90 : 0);
    // VTK positions text by the bottom of the deepest letter of the font.
    const double below = depth_of_letters * size;
    const double x = upwards ? left.x + below : left.x, y = upwards ? left.y : left.y - below;
    painter_.DrawString(static_cast<float>(smoothing_ * x), static_cast<float>(smoothing_ * y), text);
  }

  void clip(const std::optional<Box>& box) override {
    painter_.GetDevice()->EnableClipping(box.has_value());
    if (!box) return;
    const auto whole = [this](double x) { return static_cast<int>(std::lround(smoothing_ * x)); };
    int sizes[] = {whole(box->left), whole(box->bottom), whole(box->right - box->left),
                   whole(box->top - box->bottom)};
    painter_.GetDevice()->SetClipping(sizes);
  }

 private:
  std::vector<float> fine(const std::vector<Spot>& line) const {
    std::vector<float> numbers;
    for (const Spot& p : line)
      numbers.insert(numbers.end(),
                     {static_cast<float>(smoothing_ * p.x), static_cast<float>(smoothing_ * p.y)});
    return numbers;
  }

  vtkContext2D& painter_;
  int smoothing_;
};

/// Passes VTK's painter to `paint`. An exception must not pass through VTK, so it is stored in `caught`.
class Item : public vtkContextItem {
 public:
  static Item* New();
  bool Paint(vtkContext2D* painter) override {
    try {
      PixelCanvas canvas(*painter, smoothing);
      paint(canvas);
    } catch (...) {
      caught = std::current_exception();
    }
    return true;
  }
  std::function<void(Canvas&)> paint;
  int smoothing = 1;
  std::exception_ptr caught;
};
vtkStandardNewMacro(Item);

/// The mean of each smoothing x smoothing pixels.
Pixels averaged(const vtkUnsignedCharArray& all, int width, int height, int smoothing) {
  Pixels pixels{width, height, {}};
  pixels.rgba.reserve(4 * std::size_t(width) * std::size_t(height));
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      for (int c = 0; c < 3; ++c) {
        int sum = 0;
        for (int n = 0; n < smoothing * smoothing; ++n) {
          const vtkIdType row = y * smoothing + n / smoothing, column = x * smoothing + n % smoothing;
          sum += all.GetValue(4 * (row * width * smoothing + column) + c);
        }
        pixels.rgba.push_back(static_cast<std::uint8_t>(sum / (smoothing * smoothing)));
      }
      pixels.rgba.push_back(255);
    }
  return pixels;
}

}  // namespace

Pixels painted(int width, int height, const std::function<void(Canvas& canvas)>& paint) {
  const int smoothing = smoothing_of(width, height);
  OffscreenWindow window(smoothing * width, smoothing * height);
  vtkNew<Item> item;
  item->smoothing = smoothing;
  item->paint = paint;
  vtkNew<vtkContextActor> actor;
  actor->GetScene()->AddItem(item);
  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(actor);
  renderer->SetBackground(background_colour[0], background_colour[1], background_colour[2]);
  window.vtk().AddRenderer(renderer);
  window.vtk().Render();
  if (item->caught) std::rethrow_exception(item->caught);
  vtkNew<vtkUnsignedCharArray> pixels;
  window.vtk().GetRGBACharPixelData(0, 0, smoothing * width - 1, smoothing * height - 1, 0, pixels);
  if (!window.complaint().empty()) throw std::runtime_error("cannot draw: " + window.complaint());
  return averaged(*pixels, width, height, smoothing);
}

}  // namespace furnas
