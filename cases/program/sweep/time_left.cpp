#include "cases/program/sweep/time_left.h"

#include <algorithm>

namespace furnas {

double seconds_left(const SweepWork& work, double seconds, double expected) {
  constexpr double minute = 60;
  double left = work.left, done = work.done;
  for (const RunningWork& r : work.running) {
    const double counted = std::min(r.done, r.cost);
    left -= counted;
    done += std::max(counted - r.head_start, 0.0);
  }
  const double pace = (done + minute * expected) / (seconds + minute);
  return std::max(left, 0.0) / pace;
}

}  // namespace furnas
