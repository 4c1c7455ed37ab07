#pragma once

#include <filesystem>
#include <string>

#include "engine/model.h"
#include "engine/state/packing.h"
#include "io/case.h"

namespace furnas {

/// The lines of a LAMMPS input deck with the contact law: hooke_history of furnas, with the constants of a
/// model.
std::string lammps_law(const Model& model);

/// The line of the input deck that moves spheres and cell: `fix nph/sphere` with pressure, inertia and drag
/// of a model's bath, or `fix nve/sphere` in a fixed cell.
std::string lammps_bath(const Packing& packing, const Model& model);

/// The packing in the form of a LAMMPS data file: with a cell at rest, with velocities but without histories,
/// and with image counts of zero, because LAMMPS counts no more than 512 images.
Packing for_lammps(Packing packing);

/// Writes all that LAMMPS needs to continue a compaction: packing.data, in.furnas, a README, and back.toml,
/// the case with which furnas continues from the packing of LAMMPS.
///
/// `source` names the origin of the packing. `reached` is the number of the case's pressures at which the
/// packing has come to rest. Makes the folder. Throws InputError, OutputError.
void write_lammps_kit(const Packing& packing, const Case& c, std::size_t reached, const std::string& source,
                      const std::filesystem::path& folder);

}  // namespace furnas
