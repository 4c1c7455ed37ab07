#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "engine/events/at_rest.h"

namespace furnas {

/// How a criterion of rest moves.
enum class Trend { unknown, falls, stands, rises };

/// What a run may still take; infinite where the trend leads nowhere [steps].
struct StepsLeft {
  double low{}, likely{}, high{};
};

/// Follows the criteria of rest to their limits: each is taken to go on as an exponential of time.
///
/// It is an estimate. The packing may rearrange, which takes longer, or be stilled or minimized, which ends
/// the run sooner: docs/guide/first-steps.md counts how often the truth lay in the range.
class Forecast {
 public:
  static constexpr std::size_t criteria = 4;  ///< stress, force balance, kinetic energy, drift

  /// `window`: steps that all but the drift must hold. `may_jump`: a minimizer can end the run at any time.
  Forecast(const RestCriteria& limits, std::int64_t window, bool may_jump)
      : limits_(limits), window_(static_cast<double>(window)), may_jump_(may_jump) {}

  /// Takes in a look at a later step than the last; a packing that does not carry yet says nothing.
  void add(std::int64_t step, const RestReport& report);

  /// Forgets all looks, because the pressure has changed.
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
    double end{};    ///< at the last look
  };
  std::optional<Line> line(std::size_t criterion, double part) const;
  double steps_left(double part) const;
  double rest_of_window() const;

  RestCriteria limits_;
  double window_;
  bool may_jump_;
  std::vector<Look> looks_;
  std::optional<double> holds_since_;  ///< step since which all but the drift have held
};

}  // namespace furnas
