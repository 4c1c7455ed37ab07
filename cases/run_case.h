#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "cases/commands/command.h"
#include "io/case.h"
#include "io/result.h"

namespace furnas {

/// A run to do: its case, where its files go and where it begins.
struct RunOrder {
  Case resolved_case;
  std::filesystem::path folder;        ///< exists already
  Packing start;                       ///< of the case, or where a stopped run goes on
  std::vector<RestingState> reached;   ///< before it was stopped
  std::deque<RestWatch::Look> window;  ///< likewise
  std::optional<std::chrono::seconds> walltime;
};

/// The order to run a valid case from its start; the folder is still to be named. Throws InputError.
RunOrder order_to_run(const Case& c);

/// The order to go on with the run in `folder`, with some keys of its case changed. Throws InputError.
RunOrder order_to_resume(const std::filesystem::path& folder, std::span<const std::string> changes);

/// Runs a case to its verdict, writes the folder of the run and prints what came out.
ExitCode run_case(const RunOrder& order, Console console);

/// The exit code that tells a verdict.
ExitCode exit_code_of(Verdict verdict);

/// The result as a few lines for a person.
std::string summary(const Result& result, const Case& c, const std::filesystem::path& folder);

}  // namespace furnas
