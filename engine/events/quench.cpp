#include "engine/events/quench.h"

#include <algorithm>

#include "engine/base/numbers.h"
#include "engine/base/require.h"
#include "engine/monitor/energy.h"

namespace furnas {
namespace {

/// Kinetic energy of all particles and of the cell [k_n d_s^2].
double motion(Observation& now) {
  const Measures& m = now.measures();
  return m.energy.kinetic +
         0.5 * now.simulation().model().barostat.inertia * contraction(m.cell.rate, m.cell.rate);
}

}  // namespace

bool Quench::due(Observation& now) {
  constexpr double nearly = 100;  // times the limits; the stress, which the cell follows at once, 10 times
  constexpr std::int64_t patience = 50, often = 20;
  constexpr double of_its_peak = 0.5;
  if (const double pressure = now.simulation().model().barostat.pressure; pressure != pressure_) {
    pressure_ = pressure;
    count_at_pressure_ = slow_windows_ = 0;
    peak_ = 0;
  }
  const RestReport& r = watch_.look(now);
  const RestCriteria& c = watch_.criteria();
  const bool slow =
      r.backbone > 0 && r.stress_error < 10 * c.stress_error && r.kinetic_energy < nearly * c.kinetic_energy;
  const bool window_ends = now.step() % watch_.window_length() == 0;
  if (window_ends) slow_windows_ = slow ? slow_windows_ + 1 : std::max<std::int64_t>(slow_windows_ - 1, 0);
  const bool near =
      r.force_imbalance < nearly * c.force_imbalance && r.strain_drift < nearly * c.strain_drift;
  // What moves though forces balance is felt by no contact: a bridge that spins.
  const bool unfelt =
      r.backbone > 0 && near && r.stress_error < c.stress_error && r.force_imbalance < c.force_imbalance;
  const double moving = motion(now);
  peak_ = std::max(peak_, moving);
  const bool timely = count_at_pressure_ < often ? window_ends : moving < of_its_peak * peak_;
  return timely && (unfelt || (slow && (near || slow_windows_ > patience)));
}

std::string Quench::saved() {
  return exact_text(count_, pressure_, count_at_pressure_, slow_windows_, peak_);
}

void Quench::restore(const std::string& saved) {
  if (saved.empty()) return;
  const bool read = Numbers(saved).take_all(count_, pressure_, count_at_pressure_, slow_windows_, peak_);
  if (!read || count_ < 0 || !(pressure_ >= 0) || count_at_pressure_ < 0 || slow_windows_ < 0 ||
      !(peak_ >= 0))
    throw InputError("a run remembers \"" + saved + "\" where it must remember five numbers from 0 on");
}

std::optional<Verdict> Quench::fire(Observation& now) {
  // What the step has kept of the motion, its stress and half a step of its losses, acts once more.
  now.stop_all_motion();
  peak_ = 0;
  ++count_, ++count_at_pressure_;
  return {};
}

}  // namespace furnas
