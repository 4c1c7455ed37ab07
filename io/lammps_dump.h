#pragma once

#include <filesystem>
#include <vector>

#include "engine/state/packing.h"

namespace furnas {

/// Reads all frames of a LAMMPS text dump of a periodic cell.
///
/// Columns go by name: radius or diameter, and one of x, xs, xu, xsu (y, z) are needed; id, ix iy iz, mass,
/// vx, omegax, fx, tqx (y, z) are taken if there. A missing mass is that of density 1, other missing numbers
/// are zero. The cell's origin is removed. Throws InputError.
std::vector<Packing> read_lammps_dump(const std::filesystem::path& path);

/// The last frame of a dump, without keeping those before.
Packing read_last_lammps_frame(const std::filesystem::path& path);

/// Writes one frame: id type radius xu yu zu vx vy vz omegax omegay omegaz fx fy fz tqx tqy tqz, with type 1
/// large and type 2 small. Throws OutputError.
void write_lammps_dump(const Packing& packing, const std::filesystem::path& path);

}  // namespace furnas
