#pragma once

#include <cstdint>
#include <filesystem>

#include "engine/analysis/solid.h"

namespace furnas {

/// The plan of the surface of a packing as triangles, with its cost in triangles, bytes and memory.
struct SurfacePlan {
  Solid solid;
  PointGrid grid;      ///< grid of points at which distances from the surface are computed
  bool cut{};          ///< the solid is cut and closed at the faces of the box of `solid`
  double triangles{};  ///< estimate
  double bytes{};      ///< size of the file, estimate
  double memory{};     ///< needed while writing, besides the packing [bytes]
};

/// Plans the surface of the union of all spheres on a grid of this edge [d_s]. Without `cut` each sphere is
/// included once and whole; with `cut` the part of the packing and its images that lies in the box of
/// periodic_solid(). Throws InputError unless 0 < edge, and for more than 4294967295 triangles or 2^40
/// points.
SurfacePlan plan_surface(const Packing& packing, double edge, bool cut);

/// Writes the surface as a binary STL file; the surface is closed, with normals outward. Only a few planes of
/// the grid are in memory at a time. Returns the number of triangles; throws OutputError.
std::uint32_t write_stl(const SurfacePlan& plan, const std::filesystem::path& path);

}  // namespace furnas
