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

/// Runs what is not finished and what no other worker on the folder runs, and writes sweep.csv, points.csv
/// and maxima.csv into it. Throws InputError, OutputError.
ExitCode run_sweep(const SweepOrder& order, Console console);

/// How many samples a sweep has and what they cost, for a person; what will be refused is named.
std::string sweep_report(const SweepFile& sweep);

}  // namespace furnas
