#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "engine/state/packing.h"

namespace furnas {

/// Reads all frames of a LAMMPS text dump of a periodic cell.
///
/// Columns are identified by name: radius or diameter, and one of x, xs, xu, xsu (y, z) are needed; id, type,
/// element or typelabel (names of the types), ix iy iz, mass or density, vx, omegax, fx, tqx (y, z) are read
/// if present. A missing mass is that of density 1, other missing numbers are zero. A cell without boundary
/// flags counts as periodic; a general triclinic one (BOX BOUNDS abc origin) is turned (FileCell). Throws
/// InputError.
std::vector<Packing> read_lammps_dump(const std::filesystem::path& path);

/// Reads one frame of a dump, counted from 1, or the last, without keeping earlier frames in memory.
Packing read_lammps_frame(const std::filesystem::path& path, std::optional<std::int64_t> frame = {});

/// Writes one frame: id type mass radius xu yu zu vx vy vz omegax omegay omegaz fx fy fz tqx tqy tqz, after
/// type an element where types have names. LAMMPS refuses a cell tilted by more than half an edge; such a
/// cell is written with shorter edges of the same lattice. Throws OutputError.
void write_lammps_dump(const Packing& packing, const std::filesystem::path& path);

}  // namespace furnas
