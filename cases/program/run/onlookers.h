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

/// Data that the events of a run share with the code that started it.
struct RunContext {
  const Case& resolved_case;
  std::filesystem::path folder;
  std::function<void()> save;                                     ///< writes a checkpoint
  std::int64_t first_step{};                                      ///< where this process begins
  std::optional<std::chrono::steady_clock::time_point> deadline;  ///< of the wall clock
  LiveLines& lines;                                               ///< for progress
  Requests& requests;
  RestWatch& watch;
  Checkpoints& checkpoints;
};

/// The events that the program adds to those of the protocol: files, progress, wall time and signals.
Onlookers onlookers_of(RunContext& run);

}  // namespace furnas
