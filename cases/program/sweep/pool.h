#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <vector>

#include "cases/program/run/signals.h"
#include "cases/program/sweep/plan.h"
#include "cases/program/sweep/turns.h"

namespace furnas {

/// What is told of a sweep while it runs.
struct SweepStanding {
  std::size_t done{};       ///< samples that have ended, those that were finished before included
  std::size_t failed{};     ///< of those that ended now, the ones without a phi_J
  std::size_t running{};    ///< of this worker
  std::size_t elsewhere{};  ///< that other workers run
  std::size_t left{};       ///< not begun
  double seconds_left{};    ///< a guess, from the pace so far
};

/// How much of the machine and of the time a worker may use.
struct PoolLimits {
  int jobs = 1;                                                   ///< threads of all samples together
  std::optional<std::chrono::steady_clock::time_point> deadline;  ///< by which all samples are saved
  bool waits = true;                                              ///< for the samples that other workers run
};

/// Why a worker has no more to do.
enum class PoolEnd {
  whole,        ///< all samples have ended
  elsewhere,    ///< what has not ended is with other workers
  out_of_time,  ///< the deadline; some samples are saved or not begun
  stopped       ///< by a signal
};

/// Runs what is not finished of the samples and what no other worker has, the longest first, one thread for
/// each sample, more for those that would last longer than a fair share of all; and no more side by side than
/// there is memory for. Each is a process of its own, so that one that crashes stops no other. Stops early,
/// with all of them saved, when `requests` asks for it, or when `tell`, which is called now and then, throws.
PoolEnd run_samples(const std::vector<Sample>& samples, const PoolLimits& limits, const Worker& worker,
                    Turns& turns, Requests& requests, const std::function<void(const SweepStanding&)>& tell);

}  // namespace furnas
