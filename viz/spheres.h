#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "engine/state/packing.h"

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
  int axis{};             ///< edge of the cell along which the slab is cut: 0, 1 or 2
  double from{}, upto{};  ///< fractions of that edge
};

/// The spheres of all particles at their places in the cell, which is repeated `times` along its edges. With
/// a slice only particles whose centres lie in the slice are included. `colours` has one colour for each
/// particle.
std::vector<Sphere> spheres_of(const Packing& packing, const std::vector<Rgb>& colours,
                               const std::array<int, 3>& times, const std::optional<Slice>& slice);

}  // namespace furnas
