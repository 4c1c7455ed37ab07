#pragma once

#include <chrono>
#include <ctime>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "cases/program/commands/command.h"
#include "cases/program/run/continuation.h"
#include "cases/program/run/run_folder.h"
#include "io/case.h"
#include "io/result.h"

namespace furnas {

/// A run to do: its case, where its files go and where it begins.
struct RunOrder {
  Case resolved_case;
  std::unique_ptr<RunFolder> folder;
  Packing start;                ///< of the case, or where a stopped run goes on
  Continuation past;            ///< of a stopped run
  std::string checkpoint;       ///< the file that it goes on from; empty for a new run
  double checkpoint_seconds{};  ///< that reading it took
  std::string remark;           ///< a line to be shown first; empty if there is nothing to remark
  std::optional<std::chrono::seconds> walltime;
  std::chrono::steady_clock::time_point begin = std::chrono::steady_clock::now();  ///< of the wall time
  std::clock_t cpu_begin = std::clock();  ///< of the time that the process has computed
};

/// The order to run a valid case from its start; the folder is still to be named. Throws InputError.
RunOrder order_to_run(const Case& c);

/// The order to go on with the run in `folder`, with some keys of its case changed. Throws InputError, and
/// FolderInUse while another process works there.
RunOrder order_to_resume(const std::filesystem::path& folder, std::span<const std::string> changes,
                         std::optional<std::int64_t> more = {});

/// Runs a case to its verdict, writes the folder of the run and prints what came out.
ExitCode run_case(RunOrder order, Console console);

/// The exit code that tells a verdict.
ExitCode exit_code_of(Verdict verdict);

/// The result as a few lines for a person.
std::string summary(const Result& result, const Case& c, const std::filesystem::path& folder);

}  // namespace furnas
