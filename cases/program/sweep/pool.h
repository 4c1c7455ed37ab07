#pragma once

#include <functional>
#include <vector>

#include "cases/program/run/signals.h"
#include "cases/program/sweep/plan.h"

namespace furnas {

/// What is told of a sweep while it runs.
struct SweepStanding {
  std::size_t done{};    ///< samples that have ended, those that were finished before included
  std::size_t failed{};  ///< of those that ended now, the ones without a phi_J
  std::size_t running{};
  std::size_t left{};     ///< not begun
  double seconds_left{};  ///< a guess, from the pace so far
};

/// Runs what is not finished of the samples, the longest first, `jobs` threads together: one for each sample,
/// more for those that would last longer than a fair share of all; and no more side by side than there is
/// memory for. Each is a process of its own, so that one that crashes stops no other. Stops early, with all
/// of them saved, when `requests` asks for it, or when `tell`, which is called now and then, throws; answers
/// whether it went to the end.
bool run_samples(const std::vector<Sample>& samples, int jobs, Requests& requests,
                 const std::function<void(const SweepStanding&)>& tell);

}  // namespace furnas
