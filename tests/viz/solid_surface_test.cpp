#include "viz/solid_surface.h"

#include <gtest/gtest.h>
#include <vtkImageData.h>
#include <vtkMetaImageReader.h>
#include <vtkNew.h>

#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <map>
#include <numbers>
#include <utility>

#include "io/voxels.h"
#include "tests/io/packings.h"

namespace furnas {
namespace {

using Corner = std::array<float, 3>;
using Facet = std::array<Corner, 3>;

std::vector<Facet> facets_of(const std::filesystem::path& path) {
  const std::string bytes = content(path);
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + 80, 4);
  std::vector<Facet> facets(count);
  for (std::uint32_t n = 0; n < count; ++n)
    std::memcpy(facets[n].data(), bytes.data() + 84 + 50 * std::size_t{n} + 12, sizeof(Facet));
  return facets;
}

/// What the facets enclose; positive if they are counter-clockwise from outside.
double volume_of(const std::vector<Facet>& facets) {
  double volume = 0;
  for (const auto& [a, b, c] : facets) {
    const auto v = [](const Corner& k) { return Vec3<double>{k[0], k[1], k[2]}; };
    volume += dot(v(a), cross(v(b), v(c))) / 6;
  }
  return volume;
}

/// Whether each edge is met once in either direction.
bool is_closed(const std::vector<Facet>& facets) {
  std::map<std::pair<Corner, Corner>, int> edges;
  for (const Facet& f : facets)
    for (std::size_t k = 0; k < 3; ++k) {
      const Corner &a = f[k], &b = f[(k + 1) % 3];
      a < b ? ++edges[{a, b}] : --edges[{b, a}];
    }
  return std::all_of(edges.begin(), edges.end(), [](const auto& edge) { return edge.second == 0; });
}

/// Two spheres that overlap, and one on its own across the faces of a sheared cell.
Packing three_spheres() {
  Packing p;
  p.cell.edges = {4, 3.5, 3, 0.7, -0.4, 0.9};
  p.resize(3);
  p.fraction = {to_fraction({0.02, 0.97, 0.01}), to_fraction({0.5, 0.4, 0.6}), to_fraction({0.7, 0.45, 0.6})};
  p.radius = {0.5, 0.7, 0.3};
  return p;
}

/// Corners lie on the surface and facets inside it, so that the volume lacks what goes as the square of the
/// edge: what two edges give extrapolates to the volume itself.
double extrapolated_volume(const Packing& p, bool cut) {
  const TemporaryFolder folder;
  const auto volume_at = [&](double edge) {
    write_stl(plan_surface(p, edge, cut), folder / "a.stl");
    return volume_of(facets_of(folder / "a.stl"));
  };
  return (4 * volume_at(0.025) - volume_at(0.05)) / 3;
}

TEST(SolidSurface, OfASphereHasItsVolumeAndTheForetoldTriangles) {
  const TemporaryFolder folder;
  Packing p = three_spheres();
  p.resize(1);
  const SurfacePlan plan = plan_surface(p, 0.02, false);
  const std::uint32_t written = write_stl(plan, folder / "a.stl");
  const auto facets = facets_of(folder / "a.stl");
  ASSERT_EQ(facets.size(), written);
  EXPECT_NEAR(static_cast<double>(written), plan.triangles, 0.02 * plan.triangles);
  EXPECT_NEAR(volume_of(facets), p.sphere_volume(), 2e-3 * p.sphere_volume());
  EXPECT_TRUE(is_closed(facets));
  for (const Facet& facet : facets)
    for (const auto& [x, y, z] : facet)
      ASSERT_NEAR(norm(Vec3<double>{x, y, z} - p.position(0)), 0.5, 3e-4)
          << "as far as 0.02^2/8/0.5, and more";
}

TEST(SolidSurface, OfSpheresThatOverlapIsOneClosedSurface) {
  const TemporaryFolder folder;
  const Packing p = three_spheres();
  write_stl(plan_surface(p, 0.05, false), folder / "a.stl");
  const auto facets = facets_of(folder / "a.stl");
  EXPECT_TRUE(is_closed(facets)) << "over the seams of the slabs, too";
  // The lens that two spheres share counts once.
  const double R = 0.7, r = 0.3, d = norm(p.position(1) - p.position(2));
  const double lens = std::numbers::pi * std::pow(R + r - d, 2) *
                      (d * d + 2 * d * (R + r) - 3 * (R - r) * (R - r)) / (12 * d);
  ASSERT_GT(lens, 1e-2);
  EXPECT_NEAR(extrapolated_volume(p, false), p.sphere_volume() - lens, 2e-4);
}

TEST(SolidSurface, CutAtTheBoxIsClosedAndHasTheVolumeOfTheSpheres) {
  const TemporaryFolder folder;
  Packing p = three_spheres();
  p.resize(2);
  const SurfacePlan plan = plan_surface(p, 0.05, true);
  write_stl(plan, folder / "a.stl");
  const auto facets = facets_of(folder / "a.stl");
  EXPECT_TRUE(is_closed(facets));
  EXPECT_NEAR(extrapolated_volume(p, true), p.sphere_volume(), 2e-4)
      << "what one face cuts off comes in at another";
  for (const Facet& facet : facets)
    for (const auto& [x, y, z] : facet) {
      ASSERT_TRUE(x > -1e-5 && x < 4 + 1e-5 && y > -1e-5 && y < 3.5 + 1e-5 && z > -1e-5 && z < 3 + 1e-5);
    }
}

TEST(Voxels, AreReadByVtk) {
  const TemporaryFolder folder;
  const VoxelPlan plan = plan_voxels(three_spheres(), 0.2);
  write_voxels(plan, folder / "a.mhd");
  vtkNew<vtkMetaImageReader> reader;
  ASSERT_NE(reader->CanReadFile((folder / "a.mhd").c_str()), 0);
  reader->SetFileName((folder / "a.mhd").c_str());
  reader->Update();
  vtkImageData& image = *reader->GetOutput();
  const std::string data = content(folder / "a.raw");
  ASSERT_EQ(image.GetNumberOfPoints(), static_cast<vtkIdType>(data.size()));
  for (int axis = 0; axis < 3; ++axis)
    EXPECT_EQ(image.GetDimensions()[axis], plan.grid.points[static_cast<std::size_t>(axis)]);
  EXPECT_EQ(std::memcmp(image.GetScalarPointer(), data.data(), data.size()), 0);
}

}  // namespace
}  // namespace furnas
