#pragma once

#include <cstddef>
#include <vector>

#include "engine/base/vec3.h"
#include "engine/state/cell.h"

namespace furnas {

/// A change of a packing and its cell: x becomes (1 + e) x + u for each particle, h becomes (1 + e) h. A
/// gradient is written the same way, its components being the derivatives by u and e.
struct Shift {
  std::vector<Vec3<double>> displacement;  ///< u of each particle, in order of memory [d_s]
  Triangle strain;                         ///< e

  explicit Shift(std::size_t particles = 0) : displacement(particles) {}
};

/// Sum over all components. Like the following it is a loop that threads may share (engine/base/parallel.h),
/// with the same bits for any number of them.
double dot(const Shift& a, const Shift& b);

/// a + factor b, put into `sum`, which may be one of the two.
void add(const Shift& a, double factor, const Shift& b, Shift& sum);

/// `to` += factor b; gives the new `to` . c.
double add_and_dot(Shift& to, double factor, const Shift& b, const Shift& c);

/// Each component of b times that of `weight`, put into `product`, which may be b.
void multiply(const Shift& weight, const Shift& b, Shift& product);

/// a + factor b of two triangles.
Triangle sum_of(const Triangle& a, double factor, const Triangle& b);

}  // namespace furnas
