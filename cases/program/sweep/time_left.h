#pragma once

#include <algorithm>
#include <vector>

namespace furnas {

/// The work at a sample that runs [particle-steps].
struct RunningWork {
  double cost;        ///< of the whole sample, estimated before it began
  double head_start;  ///< done before this turn
  double done;        ///< done in all turns

  /// What this turn did of the cost; nothing if earlier turns had done more than was estimated.
  double in_this_turn() const { return std::max(std::min(done, cost) - head_start, 0.0); }

  /// Whether the sample has taken more than was estimated.
  bool late() const { return done > cost; }
};

/// The work of a worker of a sweep [particle-steps].
struct SweepWork {
  double left;                       ///< cost of all samples that have not ended, of the running ones, too
  double done;                       ///< by this worker, at samples that have ended
  std::vector<RunningWork> running;  ///< samples of this worker
};

/// Estimate of the seconds until all samples have ended. The pace is that of the `seconds` so far; the
/// `expected` pace [particle-steps a second] has the weight of a minute of them. What a late sample does
/// beyond its cost counts neither as left nor as done, because nobody knows how much of it is to come.
double seconds_left(const SweepWork& work, double seconds, double expected);

}  // namespace furnas
