#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/state/cell.h"
#include "engine/state/fraction.h"

namespace furnas {

/// Pairs are listed while the gap between their surfaces is below fixed + relative (R_i + R_j).
struct Skin {
  double fixed{};     ///< room for motion [d_s]
  double relative{};  ///< room for strain of the cell, which moves large pairs more
  double operator()(double radii) const { return fixed + relative * radii; }
};

/// Which image of the partner a row means, as the nearest multiple of a quarter cell to s_i - s_j when
/// the list was built. Unlike a whole number it stays right when the difference passes half a cell. The
/// fourth is 0 and makes it a word that lanes can load.
using Quarter = std::array<std::int8_t, 4>;

/// Number of a row of the list: in 32 bits, because a billion particles would need them all.
using RowNumber = std::uint32_t;

/// A size class: particles [first, last) whose radii differ little, searched on one grid.
struct SizeClass {
  std::size_t first{}, last{};
  double smallest_radius{};  ///< [d_s]
  double largest_radius{};   ///< [d_s]
};

/// The neighbour list: each pair once, in the row of the particle that comes later in memory.
struct PairList {
  std::vector<SizeClass> classes;  ///< from the largest spheres to the smallest
  Skin skin;
  std::vector<RowNumber> first;           ///< rows of particle i are [first[i], first[i + 1])
  std::vector<std::uint32_t> partner;     ///< j <= i of each row, ascending within i
  std::vector<Quarter> quarter;           ///< image of each row; empty while every nearest image is right
  std::vector<RowNumber> incoming_first;  ///< incoming of j are [incoming_first[j], ...[j + 1])
  std::vector<RowNumber> incoming;        ///< rows in which a particle is the partner, ascending
  Triangle edges;                         ///< of the cell when the list was built [d_s]
  std::vector<Fraction> reference;        ///< positions when the list was built
  std::int64_t step{};                    ///< when the list was built
  std::int64_t builds{};                  ///< lists built so far

  std::size_t rows() const { return partner.size(); }
};

/// s_i - s_j of the image that a row means: the nearest difference and whole cells. Which quarter was
/// nearest when the list was built leaves no trace in the bits.
inline Vec3<double> row_difference(const Fraction& i, const Fraction& j, const Quarter& q) {
  const auto component = [](double nearest, std::int8_t quarters) {
    return nearest + std::nearbyint(0.25 * quarters - nearest);
  };
  const Vec3<double> d = nearest_difference(i, j);
  return {component(d.x, q[0]), component(d.y, q[1]), component(d.z, q[2])};
}

}  // namespace furnas
