#pragma once

#include <cstdint>
#include <filesystem>

#include "engine/analysis/solid.h"

namespace furnas {

/// The surface of a packing as triangles: what would be written, and what that takes.
struct SurfacePlan {
  Solid solid;
  PointGrid grid;      ///< on which distances from the surface are taken
  bool cut{};          ///< at the faces of the box of `solid`, where it is closed
  double triangles{};  ///< about
  double bytes{};      ///< of the file, about
  double memory{};     ///< while it is written, besides the packing [bytes]
};

/// The union of all spheres on a grid of this edge [d_s]: each once and whole; or, if `cut`, what of the
/// packing and its images lies in the box of periodic_solid(). Throws InputError unless 0 < edge, and for
/// more than 2^32
/// - 1 triangles or 2^40 points.
SurfacePlan plan_surface(const Packing& packing, double edge, bool cut);

/// Writes the surface as a binary STL file: closed, with its normals outward. Some planes of the grid at a
/// time. Gives the number of triangles; throws OutputError.
std::uint32_t write_stl(const SurfacePlan& plan, const std::filesystem::path& path);

}  // namespace furnas
