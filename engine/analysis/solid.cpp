#include "engine/analysis/solid.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "engine/base/require.h"

namespace furnas {
namespace {

void sort(std::vector<PlacedSphere>& spheres) {
  std::sort(spheres.begin(), spheres.end(), [](const PlacedSphere& a, const PlacedSphere& b) {
    return a.centre.z - a.radius < b.centre.z - b.radius;
  });
}

/// Whole numbers n for which offset + n length lies within `reach` of [0, length].
struct Images {
  std::int64_t first, last;
  Images(double offset, double length, double reach)
      : first(static_cast<std::int64_t>(std::ceil((-reach - offset) / length))),
        last(static_cast<std::int64_t>(std::floor((length + reach - offset) / length))) {}
};

/// Indices of the points of an axis within [from, upto].
struct Points {
  std::int64_t first, last;
  Points(double from, double upto, double origin, double spacing, std::int64_t count)
      : first(std::max<std::int64_t>(static_cast<std::int64_t>(std::ceil((from - origin) / spacing)), 0)),
        last(std::min(static_cast<std::int64_t>(std::floor((upto - origin) / spacing)), count - 1)) {}
};

}  // namespace

Solid whole_solid(const Packing& packing) {
  Solid solid;
  for (std::size_t k = 0; k < packing.size(); ++k) {
    const PlacedSphere sphere{packing.position(k), packing.radius[k]};
    const Vec3<double> all{sphere.radius, sphere.radius, sphere.radius};
    const Vec3<double> low = sphere.centre - all, high = sphere.centre + all;
    if (k == 0) solid.low = low, solid.high = high;
    solid.low = {std::min(solid.low.x, low.x), std::min(solid.low.y, low.y), std::min(solid.low.z, low.z)};
    solid.high = {std::max(solid.high.x, high.x), std::max(solid.high.y, high.y),
                  std::max(solid.high.z, high.z)};
    solid.spheres.push_back(sphere);
  }
  sort(solid.spheres);
  return solid;
}

Solid periodic_solid(const Packing& packing, double margin) {
  const Triangle& h = packing.cell.edges;
  Solid solid{{0, 0, 0}, {h.xx, h.yy, h.zz}, {}};
  for (std::size_t k = 0; k < packing.size(); ++k) {
    const double radius = packing.radius[k], reach = radius + margin;
    const Vec3<double> at = packing.position(k);
    const Images c(at.z, h.zz, reach);
    for (std::int64_t n = c.first; n <= c.last; ++n) {
      const Vec3<double> up = at + static_cast<double>(n) * Vec3<double>{h.xz, h.yz, h.zz};
      const Images b(up.y, h.yy, reach);
      for (std::int64_t m = b.first; m <= b.last; ++m) {
        const Vec3<double> aside = up + static_cast<double>(m) * Vec3<double>{h.xy, h.yy, 0};
        const Images a(aside.x, h.xx, reach);
        for (std::int64_t l = a.first; l <= a.last; ++l)
          solid.spheres.push_back({aside + static_cast<double>(l) * Vec3<double>{h.xx, 0, 0}, radius});
      }
    }
  }
  sort(solid.spheres);
  return solid;
}

PointGrid voxel_grid(const Solid& solid, double edge) {
  constexpr double most = 1099511627776.0;  // 2^40
  const Vec3<double> length = solid.high - solid.low;
  const double all = length.x * length.y * length.z / (edge * edge * edge);
  if (!(edge > 0) || !(all <= most))
    throw InputError("an edge of " + std::to_string(edge) + " makes too many voxels; allowed: above " +
                     std::to_string(std::cbrt(length.x * length.y * length.z / most)));
  PointGrid grid;
  const auto divide = [edge](double whole) { return std::max<std::int64_t>(std::llround(whole / edge), 1); };
  grid.points = {divide(length.x), divide(length.y), divide(length.z)};
  const auto step = [&](double whole, std::size_t axis) {
    return whole / static_cast<double>(grid.points[axis]);
  };
  grid.spacing = {step(length.x, 0), step(length.y, 1), step(length.z, 2)};
  grid.first = solid.low + 0.5 * grid.spacing;
  return grid;
}

/// Advances to the next plane and returns its height.
double SolidPlanes::advance() {
  require(plane_ < grid_.points[2], "the grid has no more planes");
  const double height = grid_.first.z + static_cast<double>(plane_++) * grid_.spacing.z;
  const auto& spheres = solid_.spheres;
  for (; begun_ < spheres.size() && spheres[begun_].centre.z - spheres[begun_].radius - reach_ <= height;
       ++begun_)
    reached_.push_back(&spheres[begun_]);
  std::erase_if(reached_, [&](const PlacedSphere* sphere) {
    return sphere->centre.z + sphere->radius + reach_ < height;
  });
  return height;
}

/// For each sphere and each row of the plane that it reaches: row(sphere, index of the row, square of the
/// row's distance from the centre, first and last point).
template <class Row>
void SolidPlanes::for_each_row(double height, Row&& row) const {
  for (const PlacedSphere* sphere : reached_) {
    const Vec3<double>& centre = sphere->centre;
    const double far = sphere->radius + reach_, up = height - centre.z;
    const double wide = std::sqrt(std::max(far * far - up * up, 0.0));
    const Points rows(centre.y - wide, centre.y + wide, grid_.first.y, grid_.spacing.y, grid_.points[1]);
    for (std::int64_t j = rows.first; j <= rows.last; ++j) {
      const double aside = grid_.first.y + static_cast<double>(j) * grid_.spacing.y - centre.y;
      const double off = up * up + aside * aside;
      const double half = std::sqrt(std::max(far * far - off, 0.0));
      const Points across(centre.x - half, centre.x + half, grid_.first.x, grid_.spacing.x, grid_.points[0]);
      row(*sphere, j * grid_.points[0], off, across);
    }
  }
}

void SolidPlanes::next_inside(std::span<std::uint8_t> plane) {
  require(reach_ == 0, "points within the reach of a sphere would count as points in it");
  std::fill(plane.begin(), plane.end(), std::uint8_t{0});
  for_each_row(advance(), [&](const PlacedSphere&, std::int64_t row, double, const Points& across) {
    if (across.first > across.last) return;
    std::fill_n(plane.begin() + row + across.first, across.last - across.first + 1, std::uint8_t{1});
  });
}

void SolidPlanes::next_distances(std::span<float> plane) {
  std::fill(plane.begin(), plane.end(), static_cast<float>(reach_));
  for_each_row(
      advance(), [&](const PlacedSphere& sphere, std::int64_t row, double off, const Points& across) {
        for (std::int64_t i = across.first; i <= across.last; ++i) {
          const double x = grid_.first.x + static_cast<double>(i) * grid_.spacing.x - sphere.centre.x;
          float& nearest = plane[static_cast<std::size_t>(row + i)];
          nearest = std::min(nearest, static_cast<float>(std::sqrt(off + x * x) - sphere.radius));
        }
      });
}

}  // namespace furnas
