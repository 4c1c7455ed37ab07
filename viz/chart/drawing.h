#pragma once

#include "viz/chart.h"
#include "viz/chart/canvas.h"

namespace furnas {

/// Draws a chart on a canvas of its size.
void draw(const Chart& chart, Canvas& canvas);

}  // namespace furnas
