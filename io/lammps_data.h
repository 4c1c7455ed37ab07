#pragma once

#include <filesystem>

#include "engine/state/packing.h"

namespace furnas {

/// Reads a LAMMPS data file with atom_style sphere or bpm/sphere: a periodic cell, the section Atoms (id type
/// diameter density x y z [ix iy iz]; bpm/sphere has a molecule before the type) and, if present, Velocities
/// (id vx vy vz wx wy wz).
///
/// Ids may be any integers in any order. Types may have names: in the section Atom Type Labels, in comments
/// of the section Masses, or behind "N atom types". A general triclinic cell (avec, bvec, cvec, abc origin)
/// is turned (FileCell). The step is that of the title, if it has "timestep = N". Throws InputError.
Packing read_lammps_data(const std::filesystem::path& path);

/// Writes a data file that LAMMPS and read_lammps_data read. LAMMPS refuses a cell tilted by more than half
/// an edge; such a cell is written with shorter edges of the same lattice. Throws OutputError.
void write_lammps_data(const Packing& packing, const std::filesystem::path& path);

}  // namespace furnas
