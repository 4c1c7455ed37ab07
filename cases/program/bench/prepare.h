#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cases/program/commands/command.h"

namespace furnas {

/// Which packings to make.
struct PrepareOrder {
  std::string folder = "bench";
  std::vector<double> ratios;    ///< size ratios; each has a case in cases/bench/
  std::vector<double> sizes;     ///< numbers of particles to write repeated packings of, as checkpoints
  std::vector<std::string> set;  ///< changes of keys of the cases
  std::string walltime;          ///< for each case; empty: no limit
};

/// Makes the packings that are missing: runs their cases, goes on with those that were stopped, leaves
/// finished ones as they are and says so; then writes the repeated ones.
ExitCode prepare_packings(const PrepareOrder& order, Console console);

}  // namespace furnas
