#pragma once

#include <string>

class vtkTextProperty;

namespace furnas {

/// The font of charts: DejaVu Sans, because VTK's own font has no Greek letters and no superscripts.
inline constexpr const char* font_name = "DejaVu Sans";

/// Sets the font, black, with this size [pixels].
void set_font(vtkTextProperty& letters, double size);

/// Advance width of a line of plain text at a font size [pixels].
double text_width(const std::string& text, double size);

/// Height of a capital letter or a digit, as a part of the size.
inline constexpr double capital_height = 0.73;

/// How far the deepest letters reach below the line, as a part of the size.
inline constexpr double depth_of_letters = 0.24;

}  // namespace furnas
