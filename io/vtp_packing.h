#pragma once

#include <filesystem>

#include "engine/state/packing.h"

namespace furnas {

/// Writes the particles as points with vertex cells for ParaView.
///
/// Point arrays: id, type, species (0 large, 1 small), radius, mass, image, velocity, spin, force, torque and
/// coordination (contacts of the particle). Field arrays: cell and rate (rows of the edge matrix h and of the
/// strain rate e), origin (the corner of the cell), step, TimeValue. Throws OutputError.
void write_vtp(const Packing& packing, const std::filesystem::path& path);

/// Writes each contact as a line from the centre of i along the branch to the centre of j, or of its image.
///
/// Cell arrays: i and j (ids), force (on i), normal_force (positive when it pushes), tangential_force (its
/// length), overlap, sliding. Throws OutputError.
void write_contacts_vtp(const Packing& packing, const std::filesystem::path& path);

/// Writes the twelve edges of the cell as lines. Throws OutputError.
void write_cell_vtp(const Packing& packing, const std::filesystem::path& path);

/// Reads what write_vtp() writes, also after ParaView has saved the file with default settings. Needed are
/// the point array radius and the field array cell (9 numbers); all other arrays are read if present, ids in
/// any order. Throws InputError.
Packing read_vtp(const std::filesystem::path& path);

}  // namespace furnas
