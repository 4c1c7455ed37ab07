#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/state/cell.h"
#include "engine/state/fraction.h"

namespace furnas {

/// Pairs are listed if the gap between their surfaces is below fixed + relative (R_i + R_j).
struct Skin {
  double fixed{};     ///< room for motion [d_s]
  double relative{};  ///< room for strain of the cell, whose effect grows with R_i + R_j
  double operator()(double radii) const { return fixed + relative * radii; }
};

/// Which image of the partner a row means, as the nearest multiple of a quarter cell to s_i - s_j when the
/// list was built. Unlike a number of whole cells it stays valid when the difference passes half a cell. The
/// fourth byte is 0; it fills up a 32-bit word that lanes can load.
using Quarter = std::array<std::int8_t, 4>;

/// Number of a row of the list. 32 bits are enough for about a billion particles.
using RowNumber = std::uint32_t;

/// A size class: particles [first, last) whose radii differ little, searched on one grid.
struct SizeClass {
  std::size_t first{}, last{};
  double smallest_radius{};  ///< [d_s]
  double largest_radius{};   ///< [d_s]
};

/// The neighbour list: each pair has one row, which belongs to the particle that comes later in memory.
struct PairList {
  std::vector<SizeClass> classes;  ///< from the largest spheres to the smallest
  Skin skin;
  std::vector<RowNumber> first;           ///< rows of particle i are [first[i], first[i + 1])
  std::vector<std::uint32_t> partner;     ///< j <= i of each row, ascending within i
  std::vector<Quarter> quarter;           ///< image of each row; empty if all rows mean the nearest image
  std::vector<RowNumber> incoming_first;  ///< `incoming` of j: [incoming_first[j], ...[j + 1])
  std::vector<RowNumber> incoming;        ///< rows in which j is the partner, ascending
  Triangle edges;                         ///< of the cell when the list was built [d_s]
  std::vector<Fraction> reference;        ///< positions when the list was built
  std::int64_t step{};                    ///< when the list was built
  std::int64_t builds{};                  ///< lists built so far

  std::size_t rows() const { return partner.size(); }
};

/// s_i - s_j for the image that a row means: the difference to the nearest image plus whole cells. The bits
/// of the result do not depend on which quarter was nearest when the list was built.
inline Vec3<double> row_difference(const Fraction& i, const Fraction& j, const Quarter& q) {
  const auto component = [](double nearest, std::int8_t quarters) {
    return nearest + std::nearbyint(0.25 * quarters - nearest);
  };
  const Vec3<double> d = nearest_difference(i, j);
  return {component(d.x, q[0]), component(d.y, q[1]), component(d.z, q[2])};
}

}  // namespace furnas
