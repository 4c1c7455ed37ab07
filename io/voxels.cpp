#include "io/voxels.h"

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <vector>

#include "engine/base/require.h"
#include "io/atomic_file.h"

namespace furnas {
namespace {

std::string header_text(const PointGrid& grid, const std::string& data) {
  const auto three = [](const Vec3<double>& v) { return fmt::format("{} {} {}", v.x, v.y, v.z); };
  return fmt::format(
      "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\nCompressedData = "
      "False\nOffset = {}\nElementSpacing = {}\nDimSize = {} {} {}\nElementType = "
      "MET_UCHAR\nElementDataFile = {}\n",
      three(grid.first), three(grid.spacing), grid.points[0], grid.points[1], grid.points[2], data);
}

}  // namespace

VoxelPlan plan_voxels(const Packing& packing, double edge) {
  VoxelPlan plan;
  plan.solid = periodic_solid(packing);
  plan.grid = voxel_grid(plan.solid, edge);
  const auto plane = static_cast<std::uint64_t>(plan.grid.in_a_plane());
  plan.bytes = plane * static_cast<std::uint64_t>(plan.grid.points[2]);
  constexpr double buffer = 2e6;  // bytes that the file buffers
  plan.memory = static_cast<double>(plane) + buffer +
                static_cast<double>(plan.solid.spheres.size() * (sizeof(PlacedSphere) + sizeof(const void*)));
  return plan;
}

void write_voxels(const VoxelPlan& plan, const std::filesystem::path& header) {
  if (header.extension() != ".mhd")
    throw InputError(header.string() + ": voxels are a MetaImage; allowed: a name that ends with .mhd");
  const std::filesystem::path data = std::filesystem::path(header).replace_extension(".raw");
  if (!std::filesystem::exists(header)) refuse_existing(data);
  std::vector<std::uint8_t> plane(static_cast<std::size_t>(plan.grid.in_a_plane()));
  SolidPlanes planes(plan.solid, plan.grid);
  AtomicFile file(data);
  for (std::int64_t k = 0; k < plan.grid.points[2]; ++k) {
    planes.next_inside(plane);
    file.write({reinterpret_cast<const char*>(plane.data()), plane.size()});
  }
  file.commit();
  write_file(header, header_text(plan.grid, data.filename().string()));
}

}  // namespace furnas
