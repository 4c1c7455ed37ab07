#include "viz/solid_surface.h"

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <vector>

#include "engine/base/require.h"
#include "io/stl_file.h"

namespace furnas {
namespace {

constexpr std::int64_t slab = 8;  // layers of grid cells processed at a time

/// A grid of points whose outermost points lie outside the box of the solid. At faces at which the solid is
/// cut they lie half a spacing outside, so that each face lies in the middle between two planes of the grid.
PointGrid grid_around(const Solid& solid, double edge, bool cut) {
  PointGrid grid = voxel_grid(solid, edge);
  const double beyond = cut ? 0.5 : 1.5;  // in spacings
  grid.first = solid.low - beyond * grid.spacing;
  for (std::int64_t& count : grid.points) count += cut ? 2 : 4;
  return grid;
}

double largest(const Vec3<double>& v) { return std::max({v.x, v.y, v.z}); }

/// Distance of a point from a slab from `low` to `high`; negative inside.
double beyond(double at, double low, double high) { return std::max(low - at, at - high); }

/// Distances from the surface. If the solid is cut, the distance of each point is at least its distance from
/// the box, so that the box closes the surface.
class Distances {
 public:
  explicit Distances(const SurfacePlan& plan)
      : plan_(plan), planes_(plan.solid, plan.grid, 1.01 * largest(plan.grid.spacing)) {}

  void next(std::span<float> plane) {
    planes_.next_distances(plane);
    if (plan_.cut) cut(plane);
    ++plane_;
  }

 private:
  double at(double first, double spacing, std::int64_t k) const {
    return first + spacing * static_cast<double>(k);
  }
  void cut(std::span<float> plane) const {
    const auto& [low, high, spheres] = plan_.solid;
    const auto& [first, spacing, points] = plan_.grid;
    const double z = beyond(at(first.z, spacing.z, plane_), low.z, high.z);
    std::size_t k = 0;
    for (std::int64_t j = 0; j < points[1]; ++j) {
      const double y = std::max(z, beyond(at(first.y, spacing.y, j), low.y, high.y));
      for (std::int64_t i = 0; i < points[0]; ++i, ++k)
        plane[k] = std::max(
            plane[k], static_cast<float>(std::max(y, beyond(at(first.x, spacing.x, i), low.x, high.x))));
    }
  }

  const SurfacePlan& plan_;
  SolidPlanes planes_;
  std::int64_t plane_ = 0;
};

/// Adds the triangles of the surface of zero distance between the planes `first` and `last`.
void add_surface(const PointGrid& grid, std::vector<float>& values, std::int64_t first, std::int64_t last,
                 StlFile& file) {
  vtkNew<vtkFloatArray> distances;
  distances->SetArray(values.data(), (last - first + 1) * grid.in_a_plane(), 1);
  vtkNew<vtkImageData> image;
  image->SetOrigin(grid.first.x, grid.first.y, grid.first.z);
  image->SetSpacing(grid.spacing.x, grid.spacing.y, grid.spacing.z);
  // Planes are numbered from the first plane of the whole grid, so that the points of a plane that two slabs
  // share have the same bits.
  image->SetExtent(0, static_cast<int>(grid.points[0] - 1), 0, static_cast<int>(grid.points[1] - 1),
                   static_cast<int>(first), static_cast<int>(last));
  image->GetPointData()->SetScalars(distances);
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputData(image);
  contour->SetValue(0, 0);
  contour->ComputeNormalsOff();
  contour->ComputeGradientsOff();
  contour->ComputeScalarsOff();
  contour->Update();
  vtkPolyData& found = *contour->GetOutput();
  vtkIdType count = 0;
  const vtkIdType* corners = nullptr;
  vtkCellArray& triangles = *found.GetPolys();
  for (triangles.InitTraversal(); triangles.GetNextCell(count, corners);) {
    std::array<Vec3<float>, 3> triangle;
    for (std::size_t k = 0; k < 3; ++k) {
      double x[3];
      found.GetPoint(corners[2 - k], x);  // reversed: VTK's order would give normals inward here
      triangle[k] = {static_cast<float>(x[0]), static_cast<float>(x[1]), static_cast<float>(x[2])};
    }
    file.add(triangle);
  }
}

}  // namespace

SurfacePlan plan_surface(const Packing& packing, double edge, bool cut) {
  SurfacePlan plan;
  plan.cut = cut;
  plan.solid = cut ? periodic_solid(packing, 2 * edge) : whole_solid(packing);
  plan.grid = grid_around(plan.solid, edge, cut);
  // Lines of the grid with spacing h cross the surface of a sphere at 6 pi R^2/h^2 points. Each is a corner
  // of triangles, and there are twice as many triangles as corners.
  for (const double radius : packing.radius) plan.triangles += 12 * std::numbers::pi * radius * radius;
  plan.triangles /= edge * edge;
  if (plan.triangles > std::numeric_limits<std::uint32_t>::max())
    throw InputError(fmt::format("an edge of {} makes {:.2g} triangles; allowed: an edge above {:.2g}", edge,
                                 plan.triangles, edge * std::sqrt(plan.triangles / 4.2e9)));
  if (std::max({plan.grid.points[0], plan.grid.points[1], plan.grid.points[2]}) >
      std::numeric_limits<int>::max() / 2)
    throw InputError(fmt::format("an edge of {} makes too many points along one axis", edge));
  plan.bytes = plan.triangles * StlFile::bytes_of_triangle;
  constexpr double of_point = 4, of_cell_edges = 8, of_triangle = 100, buffer = 2e6;
  const auto plane = static_cast<double>(plan.grid.in_a_plane());
  plan.memory =
      (slab + 1) * plane * (of_point + of_cell_edges) + buffer +
      plan.triangles * of_triangle * (slab + 1) / static_cast<double>(plan.grid.points[2]) +
      static_cast<double>(plan.solid.spheres.size() * (sizeof(PlacedSphere) + sizeof(PlacedSphere*)));
  return plan;
}

std::uint32_t write_stl(const SurfacePlan& plan, const std::filesystem::path& path) {
  const auto plane = static_cast<std::size_t>(plan.grid.in_a_plane());
  std::vector<float> values((slab + 1) * plane);
  const auto layer = [&](std::int64_t k) {
    return std::span(values).subspan(static_cast<std::size_t>(k) * plane, plane);
  };
  Distances distances(plan);
  StlFile file(path);
  distances.next(layer(0));
  for (std::int64_t first = 0; first + 1 < plan.grid.points[2]; first += slab) {
    const std::int64_t last = std::min(first + slab, plan.grid.points[2] - 1);
    for (std::int64_t k = first + 1; k <= last; ++k) distances.next(layer(k - first));
    add_surface(plan.grid, values, first, last, file);
    std::copy_n(layer(last - first).begin(), plane, values.begin());
  }
  file.commit();
  return file.triangles();
}

}  // namespace furnas
