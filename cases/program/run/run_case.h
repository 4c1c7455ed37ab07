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

/// An order to run: the case, the folder for the files, and the start.
struct RunOrder {
  Case resolved_case;
  std::unique_ptr<RunFolder> folder;
  Packing start;                ///< start of the case, or the packing of the stopped run
  Continuation past;            ///< of a stopped run
  std::string checkpoint;       ///< the file from which the run continues; empty for a new run
  double checkpoint_seconds{};  ///< that reading it took
  std::string remark;           ///< a line to print first; may be empty
  std::optional<std::chrono::seconds> walltime;
  std::chrono::steady_clock::time_point begin = std::chrono::steady_clock::now();  ///< of the wall time
  std::clock_t cpu_begin = std::clock();                                           ///< of the CPU time
};

/// The order to run a valid case from its start; the caller still has to set the folder. Throws InputError.
RunOrder order_to_run(const Case& c);

/// The order to continue the run in `folder`, with some keys of its case changed. Throws InputError, and
/// FolderInUse while another process uses the folder.
RunOrder order_to_resume(const std::filesystem::path& folder, std::span<const std::string> changes,
                         std::optional<std::int64_t> more = {});

/// Runs a case to its verdict, writes the folder of the run and prints the result.
ExitCode run_case(RunOrder order, Console console);

/// The exit code of a verdict.
ExitCode exit_code_of(Verdict verdict);

/// The result as a few lines for the user.
std::string summary(const Result& result, const Case& c, const std::filesystem::path& folder);

}  // namespace furnas
