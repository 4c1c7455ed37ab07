#pragma once

#include <cmath>

namespace furnas {

/// Three components of a vector. `R` is a real number, or lanes of real numbers.
template <class R>
struct Vec3 {
  R x{}, y{}, z{};

  constexpr Vec3& operator+=(const Vec3& b) { return *this = *this + b; }
  constexpr Vec3& operator-=(const Vec3& b) { return *this = *this - b; }
  constexpr Vec3& operator*=(R a) { return *this = *this * a; }

  friend constexpr Vec3 operator+(const Vec3& a, const Vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend constexpr Vec3 operator-(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend constexpr Vec3 operator-(const Vec3& a) { return {-a.x, -a.y, -a.z}; }
  friend constexpr Vec3 operator*(const Vec3& a, R s) { return {a.x * s, a.y * s, a.z * s}; }
  friend constexpr Vec3 operator*(R s, const Vec3& a) { return a * s; }
  friend bool operator==(const Vec3&, const Vec3&) = default;
};

template <class R>
constexpr R dot(const Vec3<R>& a, const Vec3<R>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class R>
constexpr Vec3<R> cross(const Vec3<R>& a, const Vec3<R>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <class R>
R norm(const Vec3<R>& a) {
  using std::sqrt;
  return sqrt(dot(a, a));
}

/// Whether all components are finite.
inline bool finite(const Vec3<double>& a) {
  return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}

}  // namespace furnas
