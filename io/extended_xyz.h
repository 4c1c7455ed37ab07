#pragma once

#include <filesystem>

#include "engine/state/packing.h"

namespace furnas {

/// Reads the first frame of an extended XYZ file of a periodic cell.
///
/// Needed are Lattice="..." (a along x, b in the plane of x and y) and the properties pos and radius; id,
/// mass, velo, force, angular_velocity and torque are taken if there. Throws InputError.
Packing read_extended_xyz(const std::filesystem::path& path);

/// Writes one frame that OVITO opens with its cell, radii, velocities and forces. Throws OutputError.
void write_extended_xyz(const Packing& packing, const std::filesystem::path& path);

}  // namespace furnas
