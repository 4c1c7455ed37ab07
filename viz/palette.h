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
/// The background, unless the picture is transparent.
inline constexpr Colour background_colour{1, 1, 1};

/// Lines and points of charts, by Okabe and Ito ("Color universal design", 2008): they can be distinguished
/// with any kind of colour blindness and in print.
inline constexpr Colour black{0, 0, 0};
inline constexpr Colour blue{0, 0.447, 0.698};
inline constexpr Colour vermilion{0.835, 0.369, 0};
inline constexpr Colour green{0, 0.620, 0.451};
inline constexpr Colour purple{0.800, 0.475, 0.655};
inline constexpr Colour orange{0.902, 0.624, 0};
inline constexpr Colour sky_blue{0.337, 0.706, 0.914};

/// The colours of the first, second, ... series.
inline constexpr std::array series_colours{blue, vermilion, green, purple, orange, sky_blue, black};

/// The colour of a particle.
constexpr const Colour& colour_of(Species species) {
  return species == Species::large ? large_colour : small_colour;
}

}  // namespace furnas
