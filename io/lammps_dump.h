#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "engine/state/packing.h"

namespace furnas {

/// Reads all frames of a LAMMPS text dump of a periodic cell.
///
/// Columns go by name: radius or diameter, and one of x, xs, xu, xsu (y, z) are needed; id, type, element or
/// typelabel (names of the types), ix iy iz, mass or density, vx, omegax, fx, tqx (y, z) are taken if there.
/// A missing mass is that of density 1, other missing numbers are zero. A cell without flags counts as
/// periodic; a general triclinic one (BOX BOUNDS abc origin) is turned (FileCell). Throws InputError.
std::vector<Packing> read_lammps_dump(const std::filesystem::path& path);

/// One frame of a dump, counted from 1, or the last, without keeping those before.
Packing read_lammps_frame(const std::filesystem::path& path, std::optional<std::int64_t> frame = {});

/// Writes one frame: id type mass radius xu yu zu vx vy vz omegax omegay omegaz fx fy fz tqx tqy tqz, after
/// type an element where types have names. Of a cell that is tilted by more than half an edge, which LAMMPS
/// refuses, shorter edges of the same lattice are written. Throws OutputError.
void write_lammps_dump(const Packing& packing, const std::filesystem::path& path);

}  // namespace furnas
