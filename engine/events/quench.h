#pragma once

#include "engine/events/at_rest.h"

namespace furnas {

/// Takes out all motion, of the particles and of the cell, once the packing is nearly at rest: when all
/// limits of the verdict hold a hundred times over, or those of balance and stress hold once, whatever moves,
/// or when stress and energy have for fifty windows though the forces never balance and the cell creeps.
///
/// What still moves then is what no law damps: a sphere that spins about its contact normal or, on two
/// contacts, about the line through them, rattlers that knock at a backbone long settled, a cell that shears
/// to and fro while contacts see peculiar velocities alone, soft modes of many spheres without friction that
/// keep each other moving. It changes no position and no force, only the time until they balance;
/// docs/decisions.md has the measurement.
///
/// At first it acts at each end of a window. Where that does not bring rest, something slow is on its way
/// that each quench holds up; from then on it acts once the motion has fallen to half of its peak. A new
/// pressure is a new beginning.
class Quench final : public Event {
 public:
  explicit Quench(RestWatch& watch) : watch_(watch) {}
  const char* name() const override { return "quench"; }
  std::int64_t next(std::int64_t step) const override { return next_multiple(step, watch_.period()); }
  bool due(Observation& now) override;
  std::optional<Verdict> fire(Observation& now) override;

  std::string saved() override;
  void restore(const std::string& saved) override;

  /// How often it has happened since the run began.
  std::int64_t count() const { return count_; }

 private:
  RestWatch& watch_;
  std::int64_t count_ = 0;
  double pressure_ = 0;  ///< of the bath when last asked; the following are since it is so [k_n/d_s]
  std::int64_t count_at_pressure_ = 0;
  std::int64_t slow_windows_ = 0;  ///< ends of windows with all but the balance nearly there, more than not
  double peak_ = 0;  ///< the largest kinetic energy of particles and cell since the last quench [k_n d_s^2]
};

}  // namespace furnas
