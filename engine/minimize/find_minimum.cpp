#include "engine/minimize/find_minimum.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <deque>
#include <utility>
#include <vector>

namespace furnas {
namespace {

/// The estimate of the second derivative from the last steps.
class Curvature {
 public:
  explicit Curvature(Shift softness)
      : softness_(std::move(softness)), scaled_(softness_.displacement.size()) {}

  void forget() { pairs_.clear(); }
  bool empty() const { return pairs_.empty(); }

  /// Updates the estimate with a step and the change of the gradient along it.
  void learn(Shift step, Shift change) {
    const double bend = dot(step, change);
    if (!(bend > 0)) return;
    if (pairs_.size() == memory) pairs_.pop_front();
    pairs_.push_back({std::move(step), std::move(change), 1 / bend});
  }

  /// Direction of descent: minus the estimated inverse second derivative times the gradient.
  void descend(const Shift& gradient, Shift& way) {
    add(gradient, -2, gradient, way);
    std::vector<double> weight(pairs_.size());
    double along = pairs_.empty() ? 0 : dot(pairs_.back().step, way);
    for (std::size_t k = pairs_.size(); k-- > 0;) {
      const Pair& p = pairs_[k];
      weight[k] = p.inverse_bend * along;
      along = add_and_dot(way, -weight[k], p.change, k > 0 ? pairs_[k - 1].step : p.change);
    }
    multiply(softness_, way, way);
    if (pairs_.empty()) return;
    const Pair& last = pairs_.back();
    multiply(softness_, last.change, scaled_);
    const double size = 1 / (last.inverse_bend * dot(last.change, scaled_));
    add(way, size - 1, way, way);
    along = dot(pairs_.front().change, way);
    for (std::size_t k = 0; k < pairs_.size(); ++k) {
      const Pair& p = pairs_[k];
      const double factor = weight[k] - p.inverse_bend * along;
      along = add_and_dot(way, factor, p.step, k + 1 < pairs_.size() ? pairs_[k + 1].change : p.step);
    }
  }

 private:
  static constexpr std::size_t memory = 10;
  struct Pair {
    Shift step, change;
    double inverse_bend;  ///< 1/(step . change)
  };
  Shift softness_, scaled_;
  std::deque<Pair> pairs_;
};

/// The state of the search: a shift from the place of the enthalpy, and the values at this shift.
class Descent {
 public:
  Descent(Enthalpy& enthalpy, std::int64_t most)
      : h_(enthalpy),
        most_(most),
        at_(h_.particles()),
        next_(h_.particles()),
        way_(h_.particles()),
        here_(h_.particles()),
        there_(h_.particles()),
        curvature_(h_.softness()) {
    look(at_, here_);
  }

  MinimumReport run(const MinimumCriteria& criteria) {
    while (!holds(criteria) && report_.evaluations < most_) {
      curvature_.descend(here_.gradient, way_);
      if (step()) continue;
      if (curvature_.empty()) {
        report_.stuck = true;
        break;
      }
      curvature_.forget();
    }
    report_.reached = holds(criteria);
    h_.move(at_);
    return report_;
  }

 private:
  bool holds(const MinimumCriteria& c) const {
    return h_.stress_error(here_) < c.stress_error && h_.force_imbalance(here_) < c.force_imbalance;
  }

  void look(const Shift& shift, Enthalpy::Point& point) {
    h_.look(shift, point);
    ++report_.evaluations;
  }

  /// Makes the present configuration the place, so that the new neighbour list is complete as far around it
  /// as possible.
  void move_place() {
    h_.move(at_);
    at_ = Shift(h_.particles());
    moved_ = false;
  }

  /// Whether the list covers a step of this length; the list is first rebuilt if that helps.
  bool in_reach(double length) {
    add(at_, length, way_, next_);
    if (h_.covers(next_)) return true;
    if (!moved_) return false;
    move_place();
    return in_reach(length);
  }

  /// One step along the direction of descent to a point where the slope is small compared with the first
  /// slope. The point is found by the rule of false position, which locates a zero between two slopes of
  /// opposite signs. Returns whether such a point was found.
  bool step() {
    constexpr double flat = 0.5;  // share of the first slope, as in Wolfe's second condition
    constexpr int tries = 20;
    const double slope = dot(here_.gradient, way_);
    if (!(slope < 0)) return false;
    double low = 0, low_slope = slope, high = 0, high_slope = 0, longest = 1e10, length = 1;
    for (int n = 0; n < tries; ++n) {
      while (length > low && !in_reach(length)) longest = length = std::max(low, 0.5 * length);
      if (!(length > low)) return false;
      look(next_, there_);
      const double here = dot(there_.gradient, way_);
      if (std::abs(here) <= flat * std::abs(slope) || (here < 0 && length >= longest)) return take(length);
      if (here > 0)
        high = length, high_slope = here;
      else
        low = length, low_slope = here;
      if (high > 0) {
        const double share = std::clamp(low_slope / (low_slope - high_slope), 0.05, 0.95);
        length = low + share * (high - low);
      } else {
        const double guess = low_slope > slope ? length * slope / (slope - low_slope) : 4 * length;
        length = std::min(std::clamp(guess, 1.2 * length, 4 * length), longest);
      }
    }
    return false;
  }

  bool take(double length) {
    Shift change(h_.particles());
    add(there_.gradient, -1, here_.gradient, change);
    add(way_, length - 1, way_, way_);
    curvature_.learn(way_, std::move(change));
    std::swap(at_, next_);
    std::swap(here_, there_);
    return moved_ = true;
  }

  Enthalpy& h_;
  std::int64_t most_;
  MinimumReport report_;
  Shift at_, next_, way_;
  bool moved_ = false;  ///< at_ differs from the place of the enthalpy
  Enthalpy::Point here_, there_;
  Curvature curvature_;
};

}  // namespace

MinimumReport find_minimum(Enthalpy& enthalpy, std::int64_t most, const MinimumCriteria& criteria) {
  return Descent(enthalpy, most).run(criteria);
}

}  // namespace furnas
