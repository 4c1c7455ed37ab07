#pragma once

#include <cstdint>
#include <filesystem>

#include "engine/analysis/solid.h"

namespace furnas {

/// A packing as voxels: the data to write, and the size of the file and of the memory.
struct VoxelPlan {
  Solid solid;            ///< periodic_solid()
  PointGrid grid;         ///< voxel_grid()
  std::uint64_t bytes{};  ///< of the file
  double memory{};        ///< while it is written, besides the packing [bytes]
};

/// Plans whole voxels that fill the box and are as close as possible to cubes of this edge [d_s]; throws
/// InputError.
VoxelPlan plan_voxels(const Packing& packing, double edge);

/// Writes a MetaImage, which ParaView, ITK and Fiji read: the header, NAME.mhd, and beside it NAME.raw, a
/// byte for each voxel, 1 in a sphere and 0 between them, x fastest. Writes plane by plane. Throws InputError
/// unless the extension is .mhd, and OutputError.
void write_voxels(const VoxelPlan& plan, const std::filesystem::path& header);

}  // namespace furnas
