#pragma once

#include <deque>

#include "engine/events/at_rest.h"

namespace furnas {

/// Takes out all motion, of the particles and of the cell, at the end of a window in which the packing is
/// nearly at rest and its backbone does not gain speed: when balance and drift are within criteria.stilling
/// times their limits, and the stress within 10 times its own; or when stress and energy have been for fifty
/// windows though the forces never balance and the cell creeps.
///
/// The motion that is left then is motion that no law damps: rattlers that knock at a backbone long settled,
/// a sphere that spins about its contact normal or, on two contacts, about the line through them, soft modes
/// of many spheres without friction. A quench changes no position and no force, only the time until forces
/// balance; docs/developer/decisions/quench.md has the measurement.
///
/// A backbone whose kinetic energy grows from look to look is unstable, and on its way to where it can rest:
/// a quench would only put that off.
class Quench final : public Event {
 public:
  explicit Quench(RestWatch& watch) : watch_(watch) {}
  const char* name() const override { return "quench"; }
  std::int64_t next(std::int64_t step) const override { return next_multiple(step, watch_.period()); }
  bool due(Observation& now) override;
  std::optional<Verdict> fire(Observation& now) override;

  std::string saved() override;
  void restore(const std::string& saved) override;

  /// Whether the backbone gained no speed in the last whole window; asked after due(), at its end.
  bool steady() const { return steady_; }

  /// How often it has happened since the run began.
  std::int64_t count() const { return count_; }

 private:
  bool growing() const;

  RestWatch& watch_;
  bool steady_ = false;
  std::int64_t count_ = 0;
  double pressure_ = 0;  ///< of the bath when last asked; the following are since it is so [k_n/d_s]
  std::int64_t slow_windows_ =
      0;  ///< windows that ended with stress and energy near their limits, less those that did not
  std::deque<double>
      energies_;  ///< of the backbone at the looks since the last quench, ten at most [k_n d_s^2]
};

}  // namespace furnas
