#include "viz/chart/font.h"

#include <vtkNew.h>
#include <vtkStdString.h>
#include <vtkTextProperty.h>
#include <vtkTextRenderer.h>

#include <cmath>
#include <filesystem>

namespace furnas {
namespace {

constexpr const char* file = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";

}  // namespace

void set_font(vtkTextProperty& letters, double size) {
  if (std::filesystem::exists(file)) {
    letters.SetFontFamily(VTK_FONT_FILE);
    letters.SetFontFile(file);
  } else {
    letters.SetFontFamilyToArial();
  }
  letters.SetBold(false);
  letters.SetItalic(false);
  letters.SetShadow(false);
  letters.SetFontSize(static_cast<int>(std::lround(size)));
  letters.SetColor(0, 0, 0);
}

double text_width(const std::string& text, double size) {
  constexpr int dots_per_inch = 72;
  constexpr double fine = 8;  // VTK measures in whole pixels, which is too coarse
  vtkNew<vtkTextProperty> letters;
  set_font(*letters, fine * size);
  int box[4]{};
  vtkTextRenderer::GetInstance()->GetBoundingBox(letters, text, box, dots_per_inch);
  return (box[1] - box[0]) / fine;
}

}  // namespace furnas
