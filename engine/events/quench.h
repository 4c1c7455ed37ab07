#pragma once

#include <deque>

#include "engine/events/at_rest.h"

namespace furnas {

/// Takes out all motion of the particles and of the cell. This happens at the end of a window in which the
/// backbone did not gain speed, if one of two conditions is met. The first: balance and drift are within
/// criteria.stilling times their limits, the stress is within 10 times its limit, and either the energy is
/// within criteria.stilling_energy times its limit or stress and balance are within their own limits. The
/// second: windows at whose end the stress is within 10 times and the energy within 100 times its limit are
/// more than fifty, less those in which this is not so, although the forces never balance and the cell
/// creeps.
///
/// The contact law damps the remaining motion little or not at all: rattlers that hit a backbone at rest,
/// spheres that spin about the normal of a single contact or about the line through two contacts, and soft
/// modes of many spheres without friction. A quench changes no position and no force, only the time until the
/// forces balance; docs/developer/decisions/quench.md has the measurement.
///
/// If the kinetic energy of the backbone grows from look to look, the backbone is unstable and moves to
/// another state of rest. A quench would only delay this motion.
class Quench final : public Event {
 public:
  explicit Quench(RestWatch& watch) : watch_(watch) {}
  const char* name() const override { return "quench"; }
  std::int64_t next(std::int64_t step) const override { return next_multiple(step, watch_.period()); }
  bool due(Observation& now) override;
  std::optional<Verdict> fire(Observation& now) override;

  std::string saved() override;
  void restore(const std::string& saved) override;

  /// Whether the backbone gained no speed in the last full window. Valid after due() at the end of the
  /// window.
  bool steady() const { return steady_; }

  /// How often motion has been taken out since the run began.
  std::int64_t count() const { return count_; }

 private:
  bool growing() const;

  RestWatch& watch_;
  bool steady_ = false;
  std::int64_t count_ = 0;
  double pressure_ = 0;  ///< of the bath at the last due(); a change resets what follows [k_n/d_s]
  std::int64_t slow_windows_ =
      0;  ///< windows that ended with stress and energy near their limits, minus the other windows
  std::deque<double>
      energies_;  ///< kinetic energy at the looks since the last quench, at most ten [k_n d_s^2]
};

}  // namespace furnas
