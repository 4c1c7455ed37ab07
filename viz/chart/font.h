#pragma once

#include <string>

class vtkTextProperty;

namespace furnas {

/// The font of charts: DejaVu Sans, for VTK's own has no Greek and no superscripts.
inline constexpr const char* font_name = "DejaVu Sans";

/// Makes letters of a size [pixels], black.
void set_font(vtkTextProperty& letters, double size);

/// How far a line of plain text of a size moves on what follows it [pixels].
double text_width(const std::string& text, double size);

/// Height of a capital letter or a digit, as a part of the size.
inline constexpr double capital_height = 0.73;

/// How far the deepest letters reach below the line, as a part of the size.
inline constexpr double depth_of_letters = 0.24;

}  // namespace furnas
