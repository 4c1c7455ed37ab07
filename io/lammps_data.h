#pragma once

#include <filesystem>

#include "engine/state/packing.h"

namespace furnas {

/// Reads a LAMMPS data file with atom_style sphere: a periodic cell, the section Atoms (id type diameter
/// density x y z [ix iy iz]) and, if there is one, Velocities (id vx vy vz wx wy wz).
///
/// Ids may be any, in any order; sorted, they become 1 ... N. The largest spheres are large, all others
/// small, whatever their types. The cell's origin is removed. Throws InputError.
Packing read_lammps_data(const std::filesystem::path& path);

/// Writes a data file that LAMMPS and read_lammps_data read; type 1 is large, type 2 small. Throws
/// OutputError.
void write_lammps_data(const Packing& packing, const std::filesystem::path& path);

}  // namespace furnas
