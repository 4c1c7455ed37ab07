#pragma once

#include <cmath>
#include <cstdint>

#include "engine/base/random.h"
#include "engine/base/vec3.h"

namespace furnas::test {

/// Random numbers that a seed alone decides.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : seed_(seed) {}

  std::uint64_t word() {
    const auto words =
        philox({static_cast<std::uint32_t>(count_), static_cast<std::uint32_t>(count_ >> 32), 7, 7}, seed_);
    ++count_;
    return std::uint64_t{words[0]} << 32 | words[1];
  }
  std::uint64_t below(std::uint64_t bound) { return word() % bound; }
  bool chance(double probability) { return between(0, 1) < probability; }
  double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(word() >> 11) * 0x1p-53);
  }
  /// A vector in the cube of half-width `size`.
  Vec3<double> vector(double size) {
    return {between(-size, size), between(-size, size), between(-size, size)};
  }
  /// A direction, uniform on the sphere.
  Vec3<double> direction() {
    for (;;) {
      const Vec3<double> v = vector(1);
      const double length = norm(v);
      if (length > 0.1 && length < 1) return (1 / length) * v;
    }
  }

 private:
  std::uint64_t seed_;
  std::uint64_t count_ = 0;
};

}  // namespace furnas::test
