#pragma once

#include <array>

#include "engine/state/packing.h"

namespace furnas {

/// Red, green, blue in [0, 1].
using Colour = std::array<double, 3>;

/// Spheres as in Fig. 1a of arXiv:2105.00977: large ones grey, small ones gold.
inline constexpr Colour large_colour{0.86, 0.86, 0.87};
/// See large_colour.
inline constexpr Colour small_colour{1.00, 0.78, 0.20};
/// Edges of the periodic cell.
inline constexpr Colour cell_colour{0.13, 0.17, 0.24};
/// Behind everything, unless the picture is transparent.
inline constexpr Colour background_colour{1, 1, 1};

/// The colour of a particle.
constexpr const Colour& colour_of(Species species) {
  return species == Species::large ? large_colour : small_colour;
}

}  // namespace furnas
