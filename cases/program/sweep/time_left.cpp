#include "cases/program/sweep/time_left.h"

namespace furnas {

double seconds_left(const SweepWork& work, double seconds, double expected) {
  constexpr double minute = 60;
  double left = work.left, done = work.done;
  for (const RunningWork& r : work.running) {
    left -= std::min(r.done, r.cost);
    done += r.in_this_turn();
  }
  const double pace = (done + minute * expected) / (seconds + minute);
  return std::max(left, 0.0) / pace;
}

}  // namespace furnas
