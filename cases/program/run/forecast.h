#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "engine/events/at_rest.h"

namespace furnas {

/// How a criterion of rest moves.
enum class Trend { unknown, falls, stands, rises };

/// Estimate of the steps that a run still needs; infinite where the trend does not lead to rest [steps].
struct StepsLeft {
  double low{}, likely{}, high{};
};

/// Extrapolates the criteria of rest to their limits; each is assumed to change exponentially with time.
///
/// This is an estimate. A rearrangement of the packing takes longer; setting all motion to zero, or the
/// minimizer, ends the run sooner. docs/guide/first-steps.md counts how often the true number was in the
/// range.
class Forecast {
 public:
  static constexpr std::size_t criteria = 4;  ///< stress, force balance, kinetic energy, drift

  /// `window`: steps during which all criteria but the drift must be met. `may_jump`: a minimizer can end the
  /// run at any time.
  Forecast(const RestCriteria& limits, std::int64_t window, bool may_jump)
      : limits_(limits), window_(static_cast<double>(window)), may_jump_(may_jump) {}

  /// Adds an observation at a later step than the last. A packing that does not carry load yet is ignored.
  void add(std::int64_t step, const RestReport& report);

  /// Deletes all observations, because the pressure has changed.
  void clear() { looks_.clear(), holds_since_.reset(); }

  /// Steps until the packing rests; nothing before a trend can be seen.
  std::optional<StepsLeft> left() const;

  Trend trend(std::size_t criterion) const;

 private:
  struct Look {
    double step{};
    std::array<double, criteria> shares{};  ///< decimal logarithm of value/limit; infinite if not known
  };
  struct Line {
    double slope{};  ///< per step
    double end{};    ///< at the last observation
  };
  std::optional<Line> line(std::size_t criterion, double part) const;
  double steps_left(double part) const;
  double rest_of_window() const;

  RestCriteria limits_;
  double window_;
  bool may_jump_;
  std::vector<Look> looks_;
  std::optional<double> holds_since_;  ///< step since which all criteria but the drift have been met
};

}  // namespace furnas
