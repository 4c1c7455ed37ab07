#pragma once

#include <filesystem>
#include <string>

#include "engine/model.h"
#include "engine/state/packing.h"
#include "io/case.h"

namespace furnas {

/// The lines of an input deck of LAMMPS that say how spheres push each other: the law that furnas calls
/// hooke_history, with the constants of a model.
std::string lammps_law(const Model& model);

/// Its line that moves spheres and cell: `fix nph/sphere` with pressure, inertia and drag of a model's bath,
/// or `fix nve/sphere` in a fixed cell.
std::string lammps_bath(const Packing& packing, const Model& model);

/// The packing as a LAMMPS data file has it: at rest in its cell, with velocities but without histories, and
/// in the first cell, because LAMMPS counts no more than 512.
Packing for_lammps(Packing packing);

/// What LAMMPS needs to go on with a compaction: packing.data, in.furnas, a README, and back.toml, the case
/// with which furnas takes up what LAMMPS has made of it.
///
/// `source` says in words where the packing is from; it has come to rest at so many of the case's pressures
/// (`reached`). Makes the folder. Throws InputError, OutputError.
void write_lammps_kit(const Packing& packing, const Case& c, std::size_t reached, const std::string& source,
                      const std::filesystem::path& folder);

}  // namespace furnas
