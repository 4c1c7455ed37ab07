#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>

#include "cases/program/run/progress.h"
#include "cases/program/run/recording.h"
#include "cases/program/run/signals.h"
#include "engine/protocol/schedule.h"
#include "io/case.h"

namespace furnas {

/// What the events of a run share with whoever started it.
struct RunContext {
  const Case& resolved_case;
  std::filesystem::path folder;
  std::function<void()> save;                                     ///< writes all that the run needs to go on
  std::int64_t first_step{};                                      ///< where this process begins
  std::optional<std::chrono::steady_clock::time_point> deadline;  ///< of the wall clock
  LiveLines& lines;                                               ///< for progress
  Requests& requests;
  RestWatch& watch;
  Checkpoints& checkpoints;
};

/// What the program adds to the events of the protocol: files, progress, the wall time and signals.
Onlookers onlookers_of(RunContext& run);

}  // namespace furnas
