#pragma once

#include "engine/events/at_rest.h"

namespace furnas {

/// For packings without friction: once the packing has found its basin of the enthalpy, moves it to the
/// minimum of the basin (engine/minimize). Time steps approach this minimum slowly, because soft modes of
/// many spheres die out over 1e5 steps and more.
///
/// The basin counts as found when the packing has a backbone, its stress is within 5 % of the bath's, and its
/// kinetic energy is below 5 % of the energy of its contacts. Earlier the motion still compacts the packing.
/// If the backbone has 1500 particles or more, or the packing 20 000 contacts or more, the forces must also
/// balance to 0.3 %: a large packing reaches its basin by many rearrangements, which happen side by side in
/// time steps and one after the other in a search. The search takes out all motion and balances the forces to
/// a part in 1e8. It is divided into many calls with one time step between them, so that the run can be saved
/// and stopped. The ledger books the energy that is removed as quenched, and the work of the bath as cell
/// work. The search gives no verdict: all criteria must hold over a window of the following steps.
///
/// A search that has found no minimum after 50 000 evaluations, or 20 000 in a large packing, is in a long
/// flat valley of the enthalpy, where time steps descend as fast. Then no search is made for five windows.
///
/// When the pressure falls, a search begins at once and ends when the stress is within 5 % of the bath's. In
/// time steps the elastic energy of the contacts would drive the cell apart: at a tenth of the pressure it is
/// enough to dilate a large packing by some per cent, beyond the contact of its spheres.
class Minimize final : public Event {
 public:
  /// `evaluations`: largest number of evaluations in one call; between calls the run can be saved and
  /// stopped. 0: as many as take one or two seconds, but at least 1000, so that the start of a search is
  /// worthwhile in large packings. `pressures`: of a run with several.
  explicit Minimize(RestWatch& watch, std::int64_t evaluations = 0, const NextPressure* pressures = nullptr)
      : watch_(watch), in_a_call_(evaluations), pressures_(pressures) {}
  const char* name() const override { return "minimize"; }
  std::int64_t next(std::int64_t step) const override;
  bool due(Observation& now) override;
  std::optional<Verdict> fire(Observation& now) override;

  std::string saved() override;
  void restore(const std::string& saved) override;

  /// Evaluations of all forces by the minimizer since the run began; one costs as much as one to two steps.
  std::int64_t evaluations() const { return evaluations_; }

 private:
  enum class Search : int { none, minimum, unloading };
  bool searching() const { return search_ != Search::none; }

  RestWatch& watch_;
  std::int64_t in_a_call_;
  const NextPressure* pressures_;
  std::int64_t evaluations_ = 0;
  Search search_ = Search::none;
  double pressure_ = 0;          ///< of the bath at the last due(); a change resets what follows [k_n/d_s]
  std::int64_t spent_ = 0;       ///< evaluations of the present search
  std::int64_t not_before_ = 0;  ///< first step at which the next search may begin
};

}  // namespace furnas
