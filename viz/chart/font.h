#pragma once

#include <string>

class vtkTextProperty;

namespace furnas {

/// The font of charts: DejaVu Sans, for VTK's own has no Greek and no superscripts.
inline constexpr const char* font_name = "DejaVu Sans";

/// Makes letters of a size [pixels], black.
void set_font(vtkTextProperty& letters, double size);

/// Width of a line of text of a size [pixels].
double text_width(const std::string& text, double size);

/// Height of a capital letter or a digit, as a part of the size.
inline constexpr double capital_height = 0.73;

}  // namespace furnas
