#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cases/program/commands/command.h"
#include "cases/program/sweep/worker.h"
#include "io/sweep_file.h"

namespace furnas {

/// A sweep to do.
struct SweepOrder {
  SweepFile file;
  std::filesystem::path folder;
  int jobs = 1;         ///< threads of all samples together
  bool refine = false;  ///< add points around the maximum of each curve
  std::chrono::duration<double> takeover = usual_takeover;
  std::optional<std::chrono::seconds> walltime;
  bool waits = true;  ///< for samples that other workers on the same folder run
};

/// Runs the samples that are not finished and that no other worker on the folder runs, and writes sweep.csv,
/// points.csv and maxima.csv into the folder. Throws InputError, OutputError.
ExitCode run_sweep(const SweepOrder& order, Console console);

/// The number of samples of a sweep and their cost, for the user, with the samples that will be refused.
std::string sweep_report(const SweepFile& sweep);

}  // namespace furnas
