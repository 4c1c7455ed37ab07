#pragma once

#include <deque>
#include <limits>
#include <string>
#include <vector>

#include "engine/compaction.h"
#include "engine/events/rhythm.h"

namespace furnas {

/// When a packing counts as jammed: all criteria must hold at every look of a window. A look is one
/// evaluation of the criteria; a window has eleven looks, at equal intervals that include both ends.
struct RestCriteria {
  bool kinetic_energy_alone = false;  ///< the rule of the paper: only the kinetic energy, of all particles
  double stress_error = 1e-3;         ///< largest |P_aa - p_a|/p_a and |P_ab|/p_a
  double force_imbalance = 1e-4;      ///< mean |net force| on the backbone/mean contact force
  double loose_imbalance = 1e-3;      ///< also accepted, as loose, if met for ten windows
  double kinetic_energy = 1e-11;      ///< per backbone particle [k_n d_s^2]
  double strain_drift = 1e-6;         ///< of the cell, per drift_time
  double largest_overlap = 0.5;       ///< of the smaller radius; beyond it the contact law is not valid
  double window = 200;                ///< [t_c]
  /// All motion is taken out (engine/events/quench.h) when balance and drift are within this multiple of
  /// their limits.
  double stilling = 100;
  /// Further condition: the energy is within this multiple of its limit, or stress and balance are within
  /// theirs.
  double stilling_energy = 1e4;
  /// No motion is taken out if the backbone's energy grows by more than this factor in half a window.
  double growth = 1.15;
  /// A run that does not come to rest ends as settled once the bound on the further change of phi
  /// (engine/events/settle.h) is below this value; 0: never.
  double phi_error = 0;
  /// How often all motion is taken out at the end, before a packing at rest counts as jammed (AtRest).
  std::int64_t final_quenches = 0;
};

/// The unit of time of the strain drift [t_c].
inline constexpr double drift_time = 2000;

/// The present values of the criteria; infinite before the first look.
struct RestReport {
  static constexpr double unknown = std::numeric_limits<double>::infinity();

  std::int64_t backbone{};  ///< particles in it
  double stress_error = unknown;
  double force_imbalance = unknown;
  double kinetic_energy = unknown;  ///< [k_n d_s^2]
  double largest_overlap{};         ///< over the smaller radius
  double strain_drift = unknown;  ///< per drift_time, over one or ten windows; infinite before a full window
  bool resting{};                 ///< all criteria were met at every look of the window
  bool loosely{};                 ///< resting, but only with the loose limit of the force balance
  std::string waiting_for;        ///< the criterion that is furthest from its limit; empty when resting
};

/// Largest |P_aa - p_a|/p_a and |P_ab|/p_a among the stress components that can strain the cell.
double stress_error(const Measures& measures, const Barostat& barostat);

/// Keeps the looks of the last ten windows and decides from them whether the packing rests. Shared by the
/// events that wait for rest.
class RestWatch {
 public:
  RestWatch(const RestCriteria& criteria, const Rhythm& rhythm)
      : criteria_(criteria),
        period_(rhythm.steps(criteria.window / looks)),
        drift_steps_(static_cast<double>(rhythm.steps(drift_time))) {}

  /// What is stored of a look.
  struct Look {
    std::int64_t step{};
    Triangle edges;        ///< [d_s]
    bool holds{};          ///< all criteria were met, apart from the drift
    bool holds_loosely{};  ///< the same with the loose limit of the force balance
  };

  /// Steps between two looks, and steps in a full window.
  std::int64_t period() const { return period_; }
  std::int64_t window_length() const { return looks * period(); }

  /// Evaluates the criteria, at most once a step.
  const RestReport& look(Observation& now);
  const RestReport& report() const { return report_; }
  const RestCriteria& criteria() const { return criteria_; }

  /// Forgets all looks, because the pressure has changed.
  void restart() { window_.clear(); }

  /// What a resumed run needs: the looks kept so far, oldest first, and the values at the last look.
  struct Saved {
    std::deque<Look> window;
    std::int64_t backbone{};  ///< this and the following values as in RestReport
    double stress_error = RestReport::unknown;
    double force_imbalance = RestReport::unknown;
    double kinetic_energy = RestReport::unknown;  ///< [k_n d_s^2]
  };
  Saved saved() const;
  void restore(Saved saved);

 private:
  static constexpr std::int64_t looks = 10;             // a window
  static constexpr std::int64_t patience = 10 * looks;  // with the loose limit
  void judge();
  double drift_over(std::int64_t count) const;
  bool all_hold(bool Look::*holds, std::int64_t count) const;
  std::string furthest() const;

  RestCriteria criteria_;
  std::int64_t period_;  // [steps]
  double drift_steps_;
  std::deque<Look> window_;
  RestReport report_;
};

/// A pressure at which the packing came to rest, or settled.
struct RestingState {
  double pressure{};  ///< [k_n/d_s]
  double phi{};
  std::int64_t step{};
  double Z_backbone{};            ///< coordination of the backbone
  std::int64_t large_rattlers{};  ///< by the threshold of the backbone, as the next
  std::int64_t small_rattlers{};
  double phi_bound = 0;  ///< bound on the further change of phi of a packing that settled; 0 at rest
};

/// The state in which a packing is now, under this pressure [k_n/d_s].
RestingState resting_state(double pressure, std::int64_t step, const Measures& measures,
                           double phi_bound = 0);

/// When the packing rests and further pressures follow, records the resting state and sets the bath of the
/// next pressure. A packing that settles goes on in the same way (engine/events/settle.h).
class NextPressure final : public Event {
 public:
  NextPressure(RestWatch& watch, std::vector<Barostat> baths, std::vector<RestingState>& reached)
      : watch_(watch), baths_(std::move(baths)), reached_(reached) {}
  const char* name() const override { return "next pressure"; }
  std::int64_t next(std::int64_t step) const override { return next_multiple(step, watch_.period()); }
  bool due(Observation& now) override;
  std::optional<Verdict> fire(Observation& now) override;

  /// Whether no further pressure follows.
  bool is_last() const { return baths_.empty(); }

  /// Step at which the pressure changed last; -1 before the first change.
  std::int64_t last_change() const { return reached_.empty() ? -1 : reached_.back().step; }

  /// Bound on the further change of phi at the pressure before, if the packing settled there; otherwise 0.
  double carried_bound() const { return reached_.empty() ? 0 : reached_.back().phi_bound; }

  /// Records the state of the packing, whose phi can change by `phi_bound`, and sets the next bath.
  void go_on(Observation& now, double phi_bound);

 private:
  RestWatch& watch_;
  std::vector<Barostat> baths_;
  std::vector<RestingState>& reached_;
};

/// Ends the run as jammed when the packing rests. If criteria.final_quenches is not 0, all motion is first
/// taken out that many times, and the packing must then still rest.
///
/// The backbone of a packing at rest does not move, but rattlers fly between it and hit it. Their hits are
/// contacts like any other in a certificate, which counts every overlap, and their forces are not in balance.
/// A single quench leaves the elastic energy of the contacts that are closed at that moment, and each rattler
/// flies off again; repeated quenches take out that energy, too, as in kinetic damping.
class AtRest final : public Event {
 public:
  /// `spacing`: steps between two quenches, about the duration of two collisions.
  AtRest(RestWatch& watch, std::int64_t spacing) : watch_(watch), spacing_(spacing) {}
  const char* name() const override { return "at rest"; }
  std::int64_t next(std::int64_t step) const override;
  bool due(Observation& now) override;
  std::optional<Verdict> fire(Observation& now) override;

  std::string saved() override;
  void restore(const std::string& saved) override;

  /// How often this event has taken out all motion since the run began.
  std::int64_t count() const { return count_; }

 private:
  bool quenching() const { return done_ > 0 && done_ < watch_.criteria().final_quenches; }

  RestWatch& watch_;
  std::int64_t spacing_;    ///< [steps]
  std::int64_t done_ = 0;   ///< quenches since the packing came to rest
  std::int64_t begun_ = 0;  ///< step of the first of them
  std::int64_t count_ = 0;
};

}  // namespace furnas
