#pragma once

#include <array>

#include "engine/state/cell.h"
#include "engine/state/fraction.h"
#include "io/text_reader.h"

namespace furnas {

/// A periodic cell as a file gives it, and the transformation from the file's coordinates to those of furnas:
/// the first edge along x, the second in the plane of x and y, the third with a positive z.
///
/// Edges of any orientation are turned into these axes, and vectors with them. In a left-handed cell the
/// third edge is reversed, which leaves the lattice unchanged.
class FileCell {
 public:
  FileCell() = default;
  /// A cell in this orientation: nothing is turned, and no number is rounded.
  FileCell(const Triangle& edges, const Vec3<double>& origin) : edges_(edges), origin_(origin) {}
  /// Any three edges from the corner `origin`.
  FileCell(const Vec3<double>& a, const Vec3<double>& b, const Vec3<double>& c, const Vec3<double>& origin);

  /// Throws InputError at the reader's line unless the edges span a cell.
  void check(const TextReader& reader) const;

  const Triangle& edges() const { return edges_; }
  /// The corner of the cell, turned like its edges [d_s].
  Vec3<double> origin() const { return turned(origin_); }
  bool is_turned() const { return is_turned_; }

  /// A vector of the file in the coordinates of furnas.
  Vec3<double> turned(const Vec3<double>& v) const;
  /// A position of the file [d_s] in units of the edges.
  Vec3<double> place_of(const Vec3<double>& position) const;
  /// A position that the file gives in units of its edges.
  Vec3<double> place_of_scaled(const Vec3<double>& scaled) const;
  /// Image counts of the file, along the edges of furnas.
  Image image_of(const Image& image) const;

 private:
  Triangle edges_;
  Vec3<double> origin_;  ///< as in the file
  std::array<Vec3<double>, 3> axes_{
      {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};  ///< axes of furnas, in coordinates of the file
  bool is_turned_ = false;
  bool is_reversed_ = false;  ///< the third edge was reversed
};

}  // namespace furnas
