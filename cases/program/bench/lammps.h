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
      "bin";  ///< "bin"; or "multi": one grid a size, its communication reduced, forces by Newton's third law
  double skin = 0.05;  ///< [d_s]
};

/// What a run of LAMMPS says of itself.
struct LammpsTiming {
  double seconds{};         ///< of its loop
  std::int64_t rebuilds{};  ///< of its neighbour list
};

/// An installed LAMMPS with a packing to move: by the law that furnas calls hooke_history, with the same
/// damping, time step and bath as a model.
class Lammps {
 public:
  /// Writes packing and input deck into `folder`. Throws InputError when no `lmp`, or for several ranks no
  /// `mpirun`, is on the PATH.
  Lammps(std::filesystem::path folder, const Packing& packing, const Model& model, int ranks);

  /// Takes `steps` time steps from the start of the packing, without histories. Throws std::runtime_error
  /// with the complaint of LAMMPS.
  LammpsTiming run(const LammpsSetting& setting, std::int64_t steps) const;

  /// The packing with the forces before the first step.
  Packing forces() const;

 private:
  enum class Dump { no, forces };
  void call(const LammpsSetting& setting, std::int64_t steps, int ranks, Dump dump) const;

  std::filesystem::path folder_;
  int ranks_;
};

/// The input deck; it leaves data, style, newton, skin, steps and dump to variables of the command line.
std::string lammps_deck(const Packing& packing, const Model& model);

/// What the log of a run tells. Throws std::runtime_error with its complaint, or when it has no timing.
LammpsTiming timing_in(const std::filesystem::path& log);

}  // namespace furnas
