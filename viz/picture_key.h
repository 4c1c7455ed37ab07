#pragma once

#include "viz/colouring.h"
#include "viz/pixels.h"

namespace furnas {

/// Height of the strip for the key below a picture of this width [pixels]; 0 if the letters would be too
/// small to read.
int height_of_key(int width);

/// The key drawn in a strip of this height, black on white. Needs no display; throws InputError when there is
/// no OpenGL.
Pixels drawn_key(const ColourKey& key, int width);

}  // namespace furnas
