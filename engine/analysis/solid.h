#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/state/packing.h"

namespace furnas {

/// A sphere of a solid [d_s].
struct PlacedSphere {
  Vec3<double> centre;
  double radius{};
};

/// The union of spheres, and the box that bounds the region of interest [d_s].
struct Solid {
  Vec3<double> low, high;             ///< corners of the box
  std::vector<PlacedSphere> spheres;  ///< sorted by their lowest point along z
};

/// Every sphere once and whole, at its place in the cell; the box is the smallest one that contains all
/// spheres.
Solid whole_solid(const Packing& packing);

/// The box from 0 to (xx, yy, zz), the diagonal of the cell's edges, with every image of a sphere that comes
/// within `margin` of it. The box has the volume of the cell and is periodic like the packing. Its image
/// along x has no shift; the image along y is shifted by xy in x; the image along z is shifted by xz in x and
/// yz in y.
Solid periodic_solid(const Packing& packing, double margin = 0);

/// Points on a rectangular grid [d_s].
struct PointGrid {
  Vec3<double> first, spacing;
  std::array<std::int64_t, 3> points{};  ///< along x, y, z

  std::int64_t in_a_plane() const { return points[0] * points[1]; }
};

/// The centres of the voxels into which the box of a solid is divided. The box holds a whole number of voxels
/// along each axis, so the voxels are cubes of this edge only approximately. Throws InputError unless 0 <
/// edge, and for more than 2^40 voxels.
PointGrid voxel_grid(const Solid& solid, double edge);

/// Tells for each point of a grid whether it lies inside a solid or how far it is from the surface. Works
/// plane by plane upwards along z, and uses only the spheres that reach into the plane.
class SolidPlanes {
 public:
  /// `reach`: distances from the surface are computed up to this value [d_s]. Solid and grid must outlive the
  /// object.
  SolidPlanes(const Solid& solid, const PointGrid& grid, double reach = 0)
      : solid_(solid), grid_(grid), reach_(reach) {}

  /// 1 for each point of the next plane that lies in a sphere, 0 for the others; x runs fastest. Only with
  /// `reach` 0.
  void next_inside(std::span<std::uint8_t> plane);

  /// Distance of each point of the next plane from the surface of the nearest sphere, negative in it; `reach`
  /// where it is larger [d_s].
  void next_distances(std::span<float> plane);

 private:
  double advance();
  template <class Row>
  void for_each_row(double height, Row&& row) const;

  const Solid& solid_;
  const PointGrid& grid_;
  double reach_;
  std::int64_t plane_ = 0;
  std::size_t begun_ = 0;                     // spheres that begin at or below the plane
  std::vector<const PlacedSphere*> reached_;  // those that reach into it
};

}  // namespace furnas
