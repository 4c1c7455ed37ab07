#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "engine/model.h"
#include "engine/state/packing.h"

namespace furnas {

/// How LAMMPS keeps its neighbour list.
struct LammpsSetting {
  std::string style =
      "bin";  ///< "bin"; or "multi": one grid per size, reduced communication, forces by Newton's third law
  double skin = 0.05;  ///< [d_s]
};

/// Numbers from the log of a run of LAMMPS.
struct LammpsTiming {
  double seconds{};         ///< of the loop over time steps
  std::int64_t rebuilds{};  ///< of the neighbour list
};

/// An installed LAMMPS with a packing. LAMMPS steps the packing with the law that furnas calls hooke_history,
/// and with the damping, time step and bath of a model.
class Lammps {
 public:
  /// Writes packing and input deck into `folder`. Throws InputError when no `lmp`, or for several ranks no
  /// `mpirun`, is on the PATH.
  Lammps(std::filesystem::path folder, const Packing& packing, const Model& model, int ranks);

  /// Takes `steps` time steps from the start of the packing, without histories. Throws std::runtime_error
  /// with the error message of LAMMPS.
  LammpsTiming run(const LammpsSetting& setting, std::int64_t steps) const;

  /// The packing with the forces before the first step.
  Packing forces() const;

 private:
  enum class Dump { no, forces };
  void call(const LammpsSetting& setting, std::int64_t steps, int ranks, Dump dump) const;

  std::filesystem::path folder_;
  int ranks_;
};

/// The input deck; style, newton, skin, steps and dump are variables of the command line.
std::string lammps_deck(const Packing& packing, const Model& model);

/// Timing from the log of a run. Throws std::runtime_error with the error message of LAMMPS, or when the log
/// has no timing.
LammpsTiming timing_in(const std::filesystem::path& log);

}  // namespace furnas
