#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cases/program/bench/lammps.h"
#include "cases/program/bench/packings.h"
#include "cases/program/table.h"

namespace furnas {

/// What to compare with LAMMPS.
struct PeersOrder {
  std::string source;                 ///< a packing, or the folder of a run
  std::optional<std::int64_t> frame;  ///< of a file with several; the last
  std::filesystem::path folder;       ///< where LAMMPS works
  ModelChoice model{.law = "hooke_history"};
  std::int64_t steps = 2000;                                ///< of each run
  int pairs = 5;                                            ///< runs of each program, in turn
  int ranks = 1;                                            ///< of LAMMPS, and threads of furnas
  std::vector<double> skins{0.005, 0.01, 0.02, 0.05, 0.1};  ///< that LAMMPS tries [d_s]
};

/// How far the forces of LAMMPS are from ours at the start, over the sum of the sizes of a particle's contact
/// forces.
struct ForceDifference {
  double median{}, largest{};
};

/// Moves one packing with furnas and with an installed LAMMPS at its best setting, in turn, and prints both
/// rates, their ratio and how far their forces differ at the start. Both begin without histories.
ExitCode compare_with_lammps(const PeersOrder& order, Console console);

/// The difference of two lists of forces on the particles of `ours`, whose contacts are known.
ForceDifference difference_of_forces(const Packing& ours, const std::vector<Vec3<double>>& theirs);

}  // namespace furnas
