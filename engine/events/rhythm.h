#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace furnas {

/// Converts times to numbers of steps. Events happen at fixed times, so that no verdict depends on the length
/// of a step.
class Rhythm {
 public:
  /// `time_step` in collision times [t_c].
  explicit Rhythm(double time_step) : time_step_(time_step) {}

  /// Number of steps in a time [t_c], at least one.
  std::int64_t steps(double time) const { return std::max<std::int64_t>(std::llround(time / time_step_), 1); }

 private:
  double time_step_;
};

}  // namespace furnas
