#include "io/file_cell.h"

#include <fmt/format.h>

#include <cmath>

#include "io/particle_rows.h"

namespace furnas {

FileCell::FileCell(const Vec3<double>& a, const Vec3<double>& b, const Vec3<double>& c,
                   const Vec3<double>& origin)
    : origin_(origin) {
  const bool lies_so = a.y == 0 && a.z == 0 && b.z == 0 && a.x > 0 && b.y > 0 && c.z > 0;
  if (lies_so) {
    edges_ = {.xx = a.x, .yy = b.y, .zz = c.z, .yz = c.y, .xz = c.x, .xy = b.x};
    return;
  }
  const Vec3<double> up = cross(a, b);
  const Vec3<double> x = (1 / norm(a)) * a, z = (1 / norm(up)) * up;
  axes_ = {x, cross(z, x), z};
  is_turned_ = true;
  is_reversed_ = dot(c, z) < 0;
  const Vec3<double> third = is_reversed_ ? -c : c;
  edges_ = {.xx = norm(a),
            .yy = norm(up) / norm(a),
            .zz = dot(third, z),
            .yz = dot(third, axes_[1]),
            .xz = dot(third, x),
            .xy = dot(b, x)};
}

void FileCell::check(const TextReader& reader) const { check_edges(reader, edges_); }

Vec3<double> FileCell::turned(const Vec3<double>& v) const {
  if (!is_turned_) return v;
  return {dot(axes_[0], v), dot(axes_[1], v), dot(axes_[2], v)};
}

Vec3<double> FileCell::place_of(const Vec3<double>& position) const {
  return in_edges(edges_, turned(position - origin_));
}

Vec3<double> FileCell::place_of_scaled(const Vec3<double>& s) const {
  return {s.x, s.y, is_reversed_ ? -s.z : s.z};
}

Image FileCell::image_of(const Image& image) const {
  return {image[0], image[1], is_reversed_ ? -image[2] : image[2]};
}

}  // namespace furnas
