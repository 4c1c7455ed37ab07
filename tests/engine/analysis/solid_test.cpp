#include "engine/analysis/solid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/base/require.h"

namespace furnas {
namespace {

/// Spheres in a sheared cell, one of them across a corner.
Packing sheared() {
  Packing p;
  p.cell.edges = {3, 2.5, 2, 0.7, -0.4, 0.9};
  p.resize(3);
  p.fraction = {to_fraction({0.02, 0.97, 0.01}), to_fraction({0.5, 0.4, 0.6}), to_fraction({0.9, 0.1, 0.55})};
  p.radius = {0.5, 0.7, 0.3};
  return p;
}

/// Whether a point lies in a sphere of the packing or in any image of it.
bool lies_in(const Packing& p, const Vec3<double>& x) {
  for (std::size_t k = 0; k < p.size(); ++k)
    for (int a = -3; a <= 3; ++a)
      for (int b = -3; b <= 3; ++b)
        for (int c = -3; c <= 3; ++c) {
          const Vec3<double> at =
              p.position(k) + p.cell.edges * Vec3<double>{double(a), double(b), double(c)};
          if (norm(x - at) <= p.radius[k]) return true;
        }
  return false;
}

TEST(Solid, PlanesAgreeWithBruteForce) {
  const Packing p = sheared();
  const Solid solid = periodic_solid(p);
  const PointGrid grid = voxel_grid(solid, 0.12);
  SolidPlanes planes(solid, grid);
  std::vector<std::uint8_t> plane(static_cast<std::size_t>(grid.in_a_plane()));
  std::int64_t inside = 0;
  for (std::int64_t k = 0; k < grid.points[2]; ++k) {
    planes.next_inside(plane);
    for (std::int64_t n = 0; n < grid.in_a_plane(); ++n) {
      const Vec3<double> x =
          grid.first + Vec3<double>{double(n % grid.points[0]) * grid.spacing.x,
                                    double(n / grid.points[0]) * grid.spacing.y, double(k) * grid.spacing.z};
      ASSERT_EQ(plane[static_cast<std::size_t>(n)] != 0, lies_in(p, x)) << n << ' ' << k;
      inside += plane[static_cast<std::size_t>(n)];
    }
  }
  EXPECT_GT(inside, 500);
}

/// The box has the volume of the cell, so that voxels count the packing fraction of spheres that do not
/// overlap.
TEST(Solid, BoxHoldsThePackingFraction) {
  Packing p = sheared();
  p.radius = {0.5, 0.55, 0.3};
  const Solid solid = periodic_solid(p);
  const PointGrid grid = voxel_grid(solid, 0.02);
  EXPECT_NEAR(grid.spacing.x * grid.spacing.y * grid.spacing.z * double(grid.in_a_plane() * grid.points[2]),
              p.cell.volume(), 1e-12);
  SolidPlanes planes(solid, grid);
  std::vector<std::uint8_t> plane(static_cast<std::size_t>(grid.in_a_plane()));
  double inside = 0;
  for (std::int64_t k = 0; k < grid.points[2]; ++k) {
    planes.next_inside(plane);
    inside += static_cast<double>(std::count(plane.begin(), plane.end(), 1));
  }
  EXPECT_NEAR(inside / double(grid.in_a_plane() * grid.points[2]), p.fraction_filled(), 2e-4);
}

TEST(Solid, DistancesAreThoseOfTheNearestSurface) {
  const Packing p = sheared();
  const Solid solid = whole_solid(p);
  const PointGrid grid = voxel_grid(solid, 0.21);
  SolidPlanes planes(solid, grid, 0.4);
  std::vector<float> plane(static_cast<std::size_t>(grid.in_a_plane()));
  for (std::int64_t k = 0; k < grid.points[2]; ++k) {
    planes.next_distances(plane);
    for (std::int64_t n = 0; n < grid.in_a_plane(); ++n) {
      const Vec3<double> x =
          grid.first + Vec3<double>{double(n % grid.points[0]) * grid.spacing.x,
                                    double(n / grid.points[0]) * grid.spacing.y, double(k) * grid.spacing.z};
      double wanted = 0.4;
      for (std::size_t m = 0; m < p.size(); ++m)
        wanted = std::min(wanted, norm(x - p.position(m)) - p.radius[m]);
      ASSERT_NEAR(plane[static_cast<std::size_t>(n)], wanted, 1e-6);
    }
  }
}

TEST(Solid, RefusesAnEdgeThatIsNone) {
  const Solid solid = periodic_solid(sheared());
  EXPECT_THROW(voxel_grid(solid, 0), InputError);
  EXPECT_THROW(voxel_grid(solid, 1e-6), InputError);
  EXPECT_EQ(voxel_grid(solid, 100).points, (std::array<std::int64_t, 3>{1, 1, 1}));
}

}  // namespace
}  // namespace furnas
