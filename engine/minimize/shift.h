#pragma once

#include <cstddef>
#include <vector>

#include "engine/base/vec3.h"
#include "engine/state/cell.h"

namespace furnas {

/// A change of a packing and its cell: x becomes (1 + e) x + u for each particle, h becomes (1 + e) h. A
/// gradient has the same form: its components are the derivatives by u and e.
struct Shift {
  std::vector<Vec3<double>> displacement;  ///< u of each particle, in order of memory [d_s]
  Triangle strain;                         ///< e

  explicit Shift(std::size_t particles = 0) : displacement(particles) {}
};

/// Scalar product over all components. This function and those below are loops that threads may share
/// (engine/base/parallel.h); the bits are the same for any number of threads.
double dot(const Shift& a, const Shift& b);

/// Writes a + factor b to `sum`, which may be a or b.
void add(const Shift& a, double factor, const Shift& b, Shift& sum);

/// `to` += factor b; returns the scalar product of the new `to` and c.
double add_and_dot(Shift& to, double factor, const Shift& b, const Shift& c);

/// Writes the product of each component of b with that of `weight` to `product`, which may be b.
void multiply(const Shift& weight, const Shift& b, Shift& product);

}  // namespace furnas
