#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "engine/state/packing.h"

namespace furnas {

/// Reads a frame of an extended XYZ file of a periodic cell: the one of this number, counted from 1, or the
/// last.
///
/// Needed are Lattice="..." and the properties pos and radius (or radii, diameter); id, type, image, mass or
/// masses, velo or momenta, force, angular_velocity and torque are read if present; the words of
/// species_name, or of species, are the types. A Lattice of any orientation is turned (FileCell). Throws
/// InputError, also where a frame does not have as many rows as its first line states.
Packing read_extended_xyz(const std::filesystem::path& path, std::optional<std::int64_t> frame = {});

/// Writes one frame that ASE and OVITO open: a chemical element for each type, its name in the column
/// species_name, and all other data of the packing except its contacts. Throws OutputError.
void write_extended_xyz(const Packing& packing, const std::filesystem::path& path);

}  // namespace furnas
