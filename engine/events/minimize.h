#pragma once

#include "engine/events/at_rest.h"

namespace furnas {

/// Without friction, puts a packing that has found its basin into the minimum of the enthalpy there
/// (engine/minimize), which steps approach slowly: soft modes of many spheres die out over 1e5 steps and
/// more.
///
/// The basin is found when the packing carries the pressure with contacts that hold and its motion is small
/// against the energy of its contacts; before, the motion still compacts the packing. Then all motion is
/// taken out and forces are balanced to a part in 1e8. A search has many calls with a step between them, so
/// that the run may be saved and stopped; the energy that goes is booked as quenched, the work of the bath as
/// that of the cell. The verdict is left to the steps that follow: all criteria must hold over a window of
/// them.
///
/// A search that has found no minimum after 50 000 evaluations is in a long flat valley, where time steps
/// descend as fast: the packing is left to the steps for five windows.
class Minimize final : public Event {
 public:
  /// `evaluations` at most in one call, between which a run may be saved and stopped; 0: a second or two of
  /// them, but for large packings enough to be worth the beginning.
  explicit Minimize(RestWatch& watch, std::int64_t evaluations = 0)
      : watch_(watch), in_a_call_(evaluations) {}
  const char* name() const override { return "minimize"; }
  std::int64_t next(std::int64_t step) const override;
  bool due(Observation& now) override;
  std::optional<Verdict> fire(Observation& now) override;

  std::string saved() override;
  void restore(const std::string& saved) override;

  /// Evaluations of all forces by the minimizer since the run began; one costs as much as one to two steps.
  std::int64_t evaluations() const { return evaluations_; }

 private:
  RestWatch& watch_;
  std::int64_t in_a_call_;
  std::int64_t evaluations_ = 0;
  bool searching_ = false;
  double pressure_ = 0;          ///< of the bath when last asked; the following are since it is so [k_n/d_s]
  std::int64_t spent_ = 0;       ///< evaluations of the search that is on
  std::int64_t not_before_ = 0;  ///< step from which on the next one may begin
};

}  // namespace furnas
