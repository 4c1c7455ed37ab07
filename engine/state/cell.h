#pragma once

#include <cmath>

#include "engine/base/vec3.h"

namespace furnas {

/// An upper-triangular 3 x 3 matrix.
struct Triangle {
  double xx{}, yy{}, zz{}, yz{}, xz{}, xy{};

  Vec3<double> operator*(const Vec3<double>& v) const;
  double determinant() const { return xx * yy * zz; }
  double trace() const { return xx + yy + zz; }
  friend bool operator==(const Triangle&, const Triangle&) = default;

  Triangle& operator+=(const Triangle& b) {
    xx += b.xx, yy += b.yy, zz += b.zz, yz += b.yz, xz += b.xz, xy += b.xy;
    return *this;
  }
  friend Triangle operator+(Triangle a, const Triangle& b) { return a += b; }
  friend Triangle operator-(const Triangle& a, const Triangle& b) { return a + -1.0 * b; }
  friend Triangle operator*(double s, const Triangle& a) {
    return {s * a.xx, s * a.yy, s * a.zz, s * a.yz, s * a.xz, s * a.xy};
  }
};

/// The upper triangle of a (x) b: a_i b_j for i <= j.
inline Triangle upper_product(const Vec3<double>& a, const Vec3<double>& b) {
  return {a.x * b.x, a.y * b.y, a.z * b.z, a.y * b.z, a.x * b.z, a.x * b.y};
}

/// h v; `R` is a number, or lanes of numbers.
template <class R>
[[gnu::always_inline]] inline Vec3<R> times(const Triangle& h, const Vec3<R>& v) {
  return {R(h.xx) * v.x + R(h.xy) * v.y + R(h.xz) * v.z, R(h.yy) * v.y + R(h.yz) * v.z, R(h.zz) * v.z};
}

inline Vec3<double> Triangle::operator*(const Vec3<double>& v) const { return times(*this, v); }

/// a : b, the sum of a_ij b_ij over all components.
inline double contraction(const Triangle& a, const Triangle& b) {
  return a.xx * b.xx + a.yy * b.yy + a.zz * b.zz + a.yz * b.yz + a.xz * b.xz + a.xy * b.xy;
}

/// Whether all six components are finite.
inline bool finite(const Triangle& t) {
  return finite(Vec3<double>{t.xx, t.yy, t.zz}) && finite(Vec3<double>{t.yz, t.xz, t.xy});
}

/// The inverse; the diagonal must not vanish.
inline Triangle inverse(const Triangle& h) {
  Triangle g;
  g.xx = 1 / h.xx;
  g.yy = 1 / h.yy;
  g.zz = 1 / h.zz;
  g.xy = -h.xy * g.xx * g.yy;
  g.yz = -h.yz * g.yy * g.zz;
  g.xz = -(h.xz * g.zz + h.xy * g.yz) * g.xx;
  return g;
}

/// The matrix product a b.
inline Triangle product(const Triangle& a, const Triangle& b) {
  return {a.xx * b.xx,
          a.yy * b.yy,
          a.zz * b.zz,
          a.yy * b.yz + a.yz * b.zz,
          a.xx * b.xz + a.xy * b.yz + a.xz * b.zz,
          a.xx * b.xy + a.xy * b.yy};
}

/// The periodic cell: its edges are the columns of `edges`; `rate` is the strain rate e, edges' = e edges.
struct Cell {
  Triangle edges;  ///< h [d_s]
  Triangle rate;   ///< e [1/time]

  double volume() const { return edges.determinant(); }
  friend bool operator==(const Cell&, const Cell&) = default;
};

/// Which of the six deformations the cell may make.
enum class CellFreedom { triclinic, orthorhombic, cubic, fixed };

/// The part of a strain, or of its rate, that such a cell can make.
inline Triangle possible(const Triangle& e, CellFreedom freedom) {
  switch (freedom) {
    case CellFreedom::triclinic:
      return e;
    case CellFreedom::orthorhombic:
      return {e.xx, e.yy, e.zz, 0, 0, 0};
    case CellFreedom::cubic: {
      if (e.xx == e.yy && e.yy == e.zz) return {e.xx, e.yy, e.zz, 0, 0, 0};  // without the rounding of a mean
      const double mean = e.trace() / 3;
      return {mean, mean, mean, 0, 0, 0};
    }
    case CellFreedom::fixed:
      break;
  }
  return {};
}

/// How far a cell has been deformed: |F - I| (Frobenius) with F = now then^-1.
inline double strain_between(const Triangle& then, const Triangle& now) {
  const Triangle f = product(now, inverse(then));
  const double xx = f.xx - 1;
  const double yy = f.yy - 1;
  const double zz = f.zz - 1;
  return std::sqrt(xx * xx + yy * yy + zz * zz + f.yz * f.yz + f.xz * f.xz + f.xy * f.xy);
}

/// Distances between opposite faces of the cell [d_s].
inline Vec3<double> heights(const Triangle& h) {
  const Triangle g = inverse(h);
  return {1 / std::sqrt(g.xx * g.xx + g.xy * g.xy + g.xz * g.xz), 1 / std::sqrt(g.yy * g.yy + g.yz * g.yz),
          std::abs(h.zz)};
}

}  // namespace furnas
