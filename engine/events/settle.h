#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/events/quench.h"

namespace furnas {

/// History of phi and stress in a run: at most 64 spans, each of the same number of looks. A look is one
/// evaluation of the criteria of rest (engine/events/at_rest.h).
class PhiRecord {
 public:
  /// The looks of one interval of time.
  struct Span {
    std::int64_t looks{};
    std::int64_t end{};     ///< step of the last look
    double low{}, high{};   ///< smallest and largest phi
    double stress_error{};  ///< largest stress error
  };

  void add(std::int64_t step, double phi, double stress_error);
  void clear() { spans_.clear(); }
  bool empty() const { return spans_.empty(); }

  /// The looks after a step, joined into one span. It includes all of the span in which the step lies.
  Span since(std::int64_t step) const;

  const std::vector<Span>& spans() const { return spans_; }
  void restore(std::vector<Span> spans) { spans_ = std::move(spans); }
  static constexpr std::size_t most_spans = 64;

 private:
  std::vector<Span> spans_;  // oldest first
};

/// When a bound on the further change of phi is below criteria.phi_error, ends the run as settled, or goes on
/// to the next pressure if one follows.
///
/// The bound is computed at the end of each window in which the stress is within 10 times its limit and the
/// backbone does not gain speed; with friction, balance and energy must also be within 100 times their
/// limits. The bound is the sum of two parts:
///   - creep and avalanches: five times the range of phi over the later half of the age, the time since the
///     packing first carried the pressure. Creep slows down with the age: if phi changes as the logarithm of
///     time, it changes by the same amount in each doubling of the age, and few runs last five more
///     doublings. Without friction it is twenty times the range where balance or energy is not within 100
///     times their limits: such a packing still rearranges;
///   - the remaining error of the stress: the change of phi that would correct it if every contact followed
///     the strain of the cell, times 3, because in a disordered packing contacts do not follow it.
/// If the packing settled at the pressure before, its bound there is added: a change of the pressure silences
/// rearrangements for a while, and they come back.
/// The first part is an empirical estimate, no proof: docs/developer/decisions/phi-with-a-bound.md counts how
/// often it was correct.
class Settle final : public Event {
 public:
  /// `next` and `quench` must come before this event in the order of events. `least_age`: steps under
  /// pressure below which no bound is given.
  Settle(RestWatch& watch, NextPressure& next, const Quench& quench, std::int64_t least_age)
      : watch_(watch), next_(next), quench_(quench), least_age_(least_age) {}
  const char* name() const override { return "settle"; }
  std::int64_t next(std::int64_t step) const override { return next_multiple(step, watch_.period()); }
  bool due(Observation& now) override;
  std::optional<Verdict> fire(Observation& now) override;

  std::string saved() override;
  void restore(const std::string& saved) override;

  /// Bound on the further change of phi at the end of the last window; infinite where none could be
  /// given.
  double bound() const { return bound_; }

 private:
  void record(Observation& now, const RestReport& report, double phi);
  double ranges_allowed(const RestReport& report, bool friction) const;

  RestWatch& watch_;
  NextPressure& next_;
  const Quench& quench_;
  std::int64_t least_age_;
  PhiRecord past_;              ///< since the packing first carried the pressure
  std::int64_t loaded_at_ = 0;  ///< step at which the packing first carried the pressure
  double bound_ = RestReport::unknown;
};

}  // namespace furnas
