#pragma once

#include <vector>

#include "tests/engine/support/setups.h"

namespace furnas::test {

/// Chains and crystals of small spheres that overlap.
constexpr double r = 0.98;      ///< distance of neighbours [d_s]
constexpr double push = 1 - r;  ///< F_n between neighbours [k_n d_s]

/// A straight chain of spheres along x that presses against its own image.
inline Packing chain(int length, double distance = r) {
  std::vector<Ball> balls(static_cast<std::size_t>(length), Ball{.position = {0, 2, 2}});
  for (int k = 0; k < length; ++k) balls[std::size_t(k)].position.x = k * distance;
  return packing_of({length * distance, 4, 4, 0, 0, 0}, balls);
}

}  // namespace furnas::test
