#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "engine/base/vec3.h"

namespace furnas {

/// A position inside the periodic cell, as a fraction of each edge in units of 2^-64.
///
/// With integers the symmetries of the cell are exact: integer overflow wraps a position through a face, a
/// cast to signed integers gives the nearest image of a difference, and a flip of the cell is an integer
/// matrix. No position can lie just outside the cell because of rounding, and no bit depends on how often a
/// particle has crossed a face.
struct Fraction {
  std::uint64_t x{}, y{}, z{};
  friend constexpr bool operator==(const Fraction&, const Fraction&) = default;
};

/// Number of cells that a particle has crossed since the start, along each edge.
using Image = std::array<std::int32_t, 3>;

inline constexpr double two_to_64 = 18446744073709551616.0;

/// The integer nearest to `fraction` * 2^64, modulo 2^64. Absolute values below 2^63 are allowed.
inline std::uint64_t to_fixed(double fraction) {
  const double part = fraction - static_cast<double>(std::llrint(fraction));  // exact, in [-1/2, 1/2]
  return part >= 0.5 ? (std::uint64_t{1} << 63) : static_cast<std::uint64_t>(std::llrint(part * two_to_64));
}

/// The fixed-point difference as a real number in [-1/2, 1/2]; 1/2 only by rounding.
inline double from_fixed(std::uint64_t difference) {
  return static_cast<double>(static_cast<std::int64_t>(difference)) * (1 / two_to_64);
}

inline Fraction to_fraction(const Vec3<double>& s) { return {to_fixed(s.x), to_fixed(s.y), to_fixed(s.z)}; }

/// The fraction as a real number in [0, 1]; 1 only by rounding.
inline Vec3<double> in_unit_cell(const Fraction& s) {
  return {static_cast<double>(s.x) * (1 / two_to_64), static_cast<double>(s.y) * (1 / two_to_64),
          static_cast<double>(s.z) * (1 / two_to_64)};
}

/// Cells crossed after a displacement of less than half a cell from `before` to `now`.
inline Image crossed(const Image& image, const Fraction& before, const Fraction& now) {
  const auto component = [](std::int32_t cells, std::uint64_t a, std::uint64_t b) {
    const bool forward = static_cast<std::int64_t>(b - a) >= 0;
    return cells + (forward && b < a ? 1 : 0) - (!forward && b > a ? 1 : 0);
  };
  return {component(image[0], before.x, now.x), component(image[1], before.y, now.y),
          component(image[2], before.z, now.z)};
}

/// s_i - s_j to the nearest image, each component in [-1/2, 1/2].
inline Vec3<double> nearest_difference(const Fraction& i, const Fraction& j) {
  return {from_fixed(i.x - j.x), from_fixed(i.y - j.y), from_fixed(i.z - j.z)};
}

}  // namespace furnas
