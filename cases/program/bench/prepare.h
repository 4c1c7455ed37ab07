#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cases/program/commands/command.h"

namespace furnas {

/// Which packings to prepare.
struct PrepareOrder {
  std::string folder = "bench";
  std::vector<double> ratios;    ///< size ratios; each has a case in cases/bench/
  std::vector<double> sizes;     ///< numbers of particles to write repeated packings of, as checkpoints
  std::vector<std::string> set;  ///< assignments to keys of the cases, as in --set
  std::string walltime;          ///< for each case; empty: no limit
};

/// Makes the missing packings: runs their cases, continues stopped runs, and reports finished ones, which it
/// leaves unchanged. Then writes the repeated packings.
ExitCode prepare_packings(const PrepareOrder& order, Console console);

}  // namespace furnas
