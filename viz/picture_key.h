#pragma once

#include "viz/colouring.h"
#include "viz/pixels.h"

namespace furnas {

/// Height of the strip below a picture of this width in which its key is drawn [pixels]; 0 where letters
/// would be too small to read.
int height_of_key(int width);

/// The key in such a strip, black on white. Needs no display; throws InputError when there is no OpenGL.
Pixels drawn_key(const ColourKey& key, int width);

}  // namespace furnas
