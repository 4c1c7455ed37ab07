#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace furnas {

/// How many steps a time takes. Events act at times, so that no verdict depends on how long a step is.
class Rhythm {
 public:
  /// `time_step` in collision times [t_c].
  explicit Rhythm(double time_step) : time_step_(time_step) {}

  /// Steps in a time [t_c], at least one.
  std::int64_t steps(double time) const { return std::max<std::int64_t>(std::llround(time / time_step_), 1); }

 private:
  double time_step_;
};

}  // namespace furnas
