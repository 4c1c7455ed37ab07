#pragma once

#include <algorithm>
#include <numbers>

#include "engine/state/packing.h"
#include "tests/engine/support/dice.h"

namespace furnas::test {

/// Edges of a cell of about `size`, with each tilt up to half of the edge it leans along.
inline Triangle random_edges(Dice& dice, double size) {
  Triangle h{size * dice.between(0.8, 1.25), size * dice.between(0.8, 1.25), size * dice.between(0.8, 1.25)};
  const auto tilt = [&] {
    return dice.chance(0.2) ? (dice.chance(0.5) ? 0.5 : -0.5) : dice.between(-0.5, 0.5);
  };
  h.xy = tilt() * h.xx;
  h.xz = tilt() * h.xx;
  h.yz = tilt() * h.yy;
  return h;
}

/// A coordinate that is likely to lie on a face, next to one, or half a cell from one.
inline std::uint64_t awkward_coordinate(Dice& dice) {
  constexpr std::uint64_t half = std::uint64_t{1} << 63;
  switch (dice.below(12)) {
    case 0:
      return 0;
    case 1:
      return 1;  // 2^-64
    case 2:
      return ~std::uint64_t{0};  // 1 - 2^-64
    case 3:
      return half;
    case 4:
      return half - 1;
    case 5:
      return half / 2;
    case 6:
      return dice.below(4) * (half / 2);
    default:
      return dice.word();
  }
}

/// What a random packing looks like.
struct RandomPacking {
  std::size_t large = 1;
  std::size_t small = 10;
  double size_ratio = 1;  ///< diameter of the large ones; that of the small ones is 1
  double cell = 5;        ///< size of the cell [d_s]
  double spread = 0;      ///< radii vary by up to this share, so that there are several size classes
  double speed = 0.1;     ///< of motion and spin
};

/// Spheres at random places, many of them awkward, that overlap as they like; no two share a centre.
inline Packing random_packing(Dice& dice, const RandomPacking& wanted) {
  Packing p;
  p.cell.edges = random_edges(dice, wanted.cell);
  p.resize(wanted.large + wanted.small);
  for (std::size_t k = 0; k < p.size(); ++k) {
    const bool large = k < wanted.large;
    p.species[k] = large ? Species::large : Species::small;
    p.radius[k] = (large ? 0.5 * wanted.size_ratio : 0.5) * (1 - wanted.spread * dice.between(0, 1));
    p.mass[k] = 4 * std::numbers::pi / 3 * p.radius[k] * p.radius[k] * p.radius[k];
    do p.fraction[k] = {awkward_coordinate(dice), awkward_coordinate(dice), awkward_coordinate(dice)};
    while (std::find(p.fraction.begin(), p.fraction.begin() + static_cast<std::ptrdiff_t>(k),
                     p.fraction[k]) != p.fraction.begin() + static_cast<std::ptrdiff_t>(k));
    p.velocity[k] = dice.vector(wanted.speed);
    p.spin[k] = dice.vector(wanted.speed);
  }
  return p;
}

}  // namespace furnas::test
