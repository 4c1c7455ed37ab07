#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <vector>

#include "cases/program/run/signals.h"
#include "cases/program/sweep/plan.h"
#include "cases/program/sweep/turns.h"

namespace furnas {

/// The progress of a running sweep.
struct SweepStanding {
  std::size_t done{};       ///< samples that have ended, including those finished before
  std::size_t failed{};     ///< samples without a phi_J among those that ended now
  std::size_t running{};    ///< samples of this worker
  std::size_t elsewhere{};  ///< samples that other workers run
  std::size_t left{};       ///< not begun
  std::size_t late{};       ///< running samples that have taken more steps than estimated
  double seconds_left{};    ///< estimate from the pace so far; it leaves out the rest of late samples
};

/// How much of the machine and of the time a worker may use.
struct PoolLimits {
  int jobs = 1;                                                   ///< threads of all samples together
  std::optional<std::chrono::steady_clock::time_point> deadline;  ///< all samples are saved by this time
  bool waits = true;  ///< true: waits for the samples that other workers run
};

/// Why a worker has no more to do.
enum class PoolEnd {
  whole,        ///< all samples have ended
  elsewhere,    ///< other workers run all samples that have not ended
  out_of_time,  ///< the deadline; some samples are saved or not begun
  stopped       ///< by a signal
};

/// Runs the samples that are not finished and that no other worker runs, the longest first. Each sample gets
/// one thread, or more if it would last longer than a fair share of the total. The samples that run side by
/// side fit into the memory. Each is a separate process, so that a crash does not stop the others. Stops
/// early, with all samples saved, when `requests` asks for it, or when `tell`, which is called now and then,
/// throws.
PoolEnd run_samples(const std::vector<Sample>& samples, const PoolLimits& limits, const Worker& worker,
                    Turns& turns, Requests& requests, const std::function<void(const SweepStanding&)>& tell);

}  // namespace furnas
