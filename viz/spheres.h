#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "engine/state/packing.h"
#include "viz/view.h"

namespace furnas {

/// Red, green, blue, 0 to 255.
using Rgb = std::array<std::uint8_t, 3>;

/// A sphere as it is drawn.
struct Sphere {
  Vec3<float> centre;  ///< [d_s]
  float radius{};      ///< [d_s]
  Rgb colour{};
};

/// A slab between two planes along one edge of the cell.
struct Slice {
  int axis{};             ///< edge of the cell that it cuts: 0, 1 or 2
  double from{}, upto{};  ///< fractions of that edge
};

/// Every particle once at its place in the cell, the cell repeated `times` along its edges. With a slice only
/// the particles whose centres lie in it. `colours` has one for each particle.
std::vector<Sphere> spheres_of(const Packing& packing, const std::vector<Rgb>& colours,
                               const std::array<int, 3>& times, const std::optional<Slice>& slice);

/// The spheres that can be seen when all are opaque, in a frame of so many pixels: a sphere of a packing of
/// many millions is nearly always hidden. May keep hidden spheres; never drops a sphere that shows in a
/// pixel.
std::vector<Sphere> visible(const std::vector<Sphere>& spheres, const View& view, int width, int height);

}  // namespace furnas
