#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/events/quench.h"

namespace furnas {

/// phi and stress of a run's past, in at most 64 spans of as many looks each.
class PhiRecord {
 public:
  /// What was seen over some time.
  struct Span {
    std::int64_t looks{};
    std::int64_t end{};     ///< step of the last one
    double low{}, high{};   ///< smallest and largest phi
    double stress_error{};  ///< the largest
  };

  void add(std::int64_t step, double phi, double stress_error);
  void clear() { spans_.clear(); }
  bool empty() const { return spans_.empty(); }

  /// All that was seen after a step, and in the rest of the span that it lies in.
  Span since(std::int64_t step) const;

  const std::vector<Span>& spans() const { return spans_; }
  void restore(std::vector<Span> spans) { spans_ = std::move(spans); }

 private:
  static constexpr std::size_t most_spans = 64;

  std::vector<Span> spans_;  // oldest first
};

/// Ends the run as settled when what phi may still change is bounded below criteria.phi_error.
///
/// The bound is asked for at the ends of windows in which the packing is nearly at rest (stress within 10
/// times its limit, balance and energy within 100 times theirs) and its backbone does not gain speed. The
/// bound is the sum of
///   - creep and avalanches: five times the range of phi over the later half of the time since the packing
///     first carried the pressure. Creep slows down with its age: what goes as the logarithm of time moves
///     phi by as much in each doubling of the age, and few runs last five doublings more;
///   - the stress that is still wrong: the change of phi that would put it right if every contact followed
///     the strain of the cell, times 3, because in a disordered packing they do not.
/// The first is an estimate from experience, no proof: docs/developer/decisions/phi-with-a-bound.md counts
/// how often it held.
class Settle final : public Event {
 public:
  /// `quench` comes before it in the order of events. `least_age`: steps under pressure before a bound means
  /// anything.
  Settle(RestWatch& watch, const Quench& quench, std::int64_t least_age)
      : watch_(watch), quench_(quench), least_age_(least_age) {}
  const char* name() const override { return "settle"; }
  std::int64_t next(std::int64_t step) const override { return next_multiple(step, watch_.period()); }
  bool due(Observation& now) override;
  std::optional<Verdict> fire(Observation&) override { return Verdict::settled; }

  std::string saved() override;
  void restore(const std::string& saved) override;

  /// Bound on what phi may still change, as of the last end of a window; infinite unless the packing was
  /// near rest there.
  double bound() const { return bound_; }

 private:
  void record(const Observation& now, const RestReport& report, double phi);
  bool is_near_rest(const RestReport& report) const;

  RestWatch& watch_;
  const Quench& quench_;
  std::int64_t least_age_;
  PhiRecord past_;              ///< since the packing first carried the pressure
  std::int64_t loaded_at_ = 0;  ///< step at which it did
  double bound_ = RestReport::unknown;
};

}  // namespace furnas
