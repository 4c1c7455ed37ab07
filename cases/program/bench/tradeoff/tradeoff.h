#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cases/program/commands/command.h"
#include "cases/program/sweep/plan.h"
#include "io/tradeoff_file.h"

namespace furnas {

/// Options of `furnas bench tradeoff`.
struct TradeoffOrder {
  std::filesystem::path file;
  std::filesystem::path folder;  ///< for samples, tables and charts
  int jobs = 1;                  ///< threads of all samples together
  int samples = 0;  ///< of each arm, instead of the number in the file; 0: the number in the file
  std::vector<std::string> cases, arms;  ///< those to compare; empty: all. The reference is always included
  bool report_only = false;              ///< run nothing, report the samples in the folder
};

/// The samples of all arms of all cases, with folders `folder`/samples/CASE/ARM/SEED. Their values are the
/// names of case and arm.
std::vector<Sample> tradeoff_samples(const TradeoffFile& tradeoff, const std::filesystem::path& folder);

/// Runs the unfinished samples in one pool, and writes tradeoff.csv, samples.csv and for each case a
/// work-precision chart, as SVG and PNG. After a stop by a signal, the same command continues. Throws
/// InputError, FolderInUse, OutputError.
ExitCode run_tradeoff(const TradeoffOrder& order, Console console);

}  // namespace furnas
