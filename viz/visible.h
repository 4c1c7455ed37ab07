#pragma once

#include <vector>

#include "viz/spheres.h"
#include "viz/view.h"

namespace furnas {

/// The spheres that are visible if all are opaque, in a frame of width x height pixels. In a packing of many
/// millions nearly all spheres are hidden. The result may contain hidden spheres, but contains every sphere
/// that is visible in a pixel.
std::vector<Sphere> visible(const std::vector<Sphere>& spheres, const View& view, int width, int height);

}  // namespace furnas
