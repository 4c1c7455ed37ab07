#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cases/program/commands/command.h"
#include "io/sweep_file.h"

namespace furnas {

/// A sweep to do.
struct SweepOrder {
  SweepFile file;
  std::filesystem::path folder;
  int jobs = 1;         ///< threads of all samples together
  bool refine = false;  ///< add points around the maximum of each curve
};

/// Runs what is not finished, and writes sweep.csv, points.csv and maxima.csv into the folder. Throws
/// InputError, FolderInUse, OutputError.
ExitCode run_sweep(const SweepOrder& order, Console console);

/// How many samples a sweep has and what they cost, for a person; what will be refused is named.
std::string sweep_report(const SweepFile& sweep);

}  // namespace furnas
