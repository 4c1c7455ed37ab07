#pragma once

#include <algorithm>
#include <concepts>

#include "engine/base/vec3.h"

namespace furnas {

/// Choices without a branch, for single numbers and for lanes of numbers (engine/kernels/lanes.h), so that
/// each law is written only once.
template <std::floating_point R>
constexpr R select(bool first, const R& a, const R& b) {
  return first ? a : b;
}

/// The same for vectors; `Truth` is a bool, or one bool per lane.
template <class Truth, class R>
[[gnu::always_inline]] inline Vec3<R> select(const Truth& first, const Vec3<R>& a, const Vec3<R>& b) {
  return {select(first, a.x, b.x), select(first, a.y, b.y), select(first, a.z, b.z)};
}

/// The larger of two numbers.
inline double larger(double a, double b) { return std::max(a, b); }

/// Whether all components are zero.
template <class R>
[[gnu::always_inline]] inline auto is_zero(const Vec3<R>& v) {
  return (v.x == R(0)) & (v.y == R(0)) & (v.z == R(0));
}

}  // namespace furnas
