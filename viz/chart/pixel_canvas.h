#pragma once

#include <functional>

#include "viz/chart/canvas.h"
#include "viz/pixels.h"

namespace furnas {

/// The pixels of what `paint` draws, with anti-aliasing. Needs no display; throws InputError when there is no
/// OpenGL or the size is not possible.
Pixels painted(int width, int height, const std::function<void(Canvas& canvas)>& paint);

}  // namespace furnas
