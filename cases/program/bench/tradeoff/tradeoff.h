#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cases/program/commands/command.h"
#include "cases/program/sweep/plan.h"
#include "io/tradeoff_file.h"

namespace furnas {

/// What `furnas bench tradeoff` does.
struct TradeoffOrder {
  std::filesystem::path file;
  std::filesystem::path folder;          ///< for samples, tables and charts
  int jobs = 1;                          ///< threads of all samples together
  int samples = 0;                       ///< of each arm, instead of those of the file; 0: those
  std::vector<std::string> cases, arms;  ///< those to compare; empty: all. The reference is always there
  bool report_only = false;              ///< run nothing, tell what the folder holds
};

/// The samples of all arms of all cases into `folder`: samples/CASE/ARM/SEED. Their values are the names of
/// case and arm.
std::vector<Sample> tradeoff_samples(const TradeoffFile& tradeoff, const std::filesystem::path& folder);

/// Runs what is not finished, in one pool, and writes tradeoff.csv, samples.csv and for each case a
/// work-precision chart, as SVG and PNG. Stopped by a signal, the same command goes on. Throws InputError,
/// FolderInUse, OutputError.
ExitCode run_tradeoff(const TradeoffOrder& order, Console console);

}  // namespace furnas
