#pragma once

#include <vector>

#include "tests/engine/support/setups.h"

namespace furnas::test {

/// Chains and crystals of small spheres that overlap.
constexpr double r = 0.98;      ///< of neighbours [d_s]
constexpr double push = 1 - r;  ///< F_n between neighbours [k_n d_s]

/// A straight chain of spheres along x that presses against its own image.
inline Packing chain(int length) {
  std::vector<Ball> balls;
  for (int k = 0; k < length; ++k) balls.push_back({.position = {k * r, 2, 2}});
  return packing_of({length * r, 4, 4, 0, 0, 0}, balls);
}

}  // namespace furnas::test
