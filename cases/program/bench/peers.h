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
  std::optional<std::int64_t> frame;  ///< of a file with several frames; empty: the last
  std::filesystem::path folder;       ///< where LAMMPS works
  ModelChoice model{.law = "hooke_history"};
  std::int64_t steps = 2000;                                ///< of each run
  int pairs = 5;                                            ///< runs of each program, alternating
  int ranks = 1;                                            ///< ranks of LAMMPS, and threads of furnas
  std::vector<double> skins{0.005, 0.01, 0.02, 0.05, 0.1};  ///< skins that LAMMPS tries [d_s]
};

/// Difference between the forces of LAMMPS and of furnas on a particle at the start, over the sum of the
/// absolute contact forces on it.
struct ForceDifference {
  double median{}, largest{};
};

/// Steps one packing with furnas and with an installed LAMMPS at its best setting, alternating, and prints
/// both rates, their ratio and the difference of the forces at the start. Both begin without histories.
ExitCode compare_with_lammps(const PeersOrder& order, Console console);

/// The difference between the forces of `ours`, whose contacts are known, and the forces `theirs` on the same
/// particles.
ForceDifference difference_of_forces(const Packing& ours, const std::vector<Vec3<double>>& theirs);

}  // namespace furnas
