#include "engine/events/quench.h"

#include <algorithm>
#include <array>
#include <charconv>

#include "engine/analysis/energy.h"
#include "engine/base/require.h"

namespace furnas {
namespace {

/// Kinetic energy of all particles and of the cell [k_n d_s^2].
double motion(Observation& now) {
  const Measures& m = now.measures();
  const Triangle& e = m.cell.rate;
  const double square = e.xx * e.xx + e.yy * e.yy + e.zz * e.zz + e.yz * e.yz + e.xz * e.xz + e.xy * e.xy;
  return m.energy.kinetic + 0.5 * now.simulation().model().barostat.inertia * square;
}

}  // namespace

bool Quench::due(Observation& now) {
  constexpr double nearly = 100;  // times the limits; the stress, which the cell follows at once, 10 times
  constexpr std::int64_t patience = 50, often = 20;
  constexpr double of_its_peak = 0.5;
  const RestReport& r = watch_.look(now);
  const RestCriteria& c = watch_.criteria();
  const bool slow =
      r.backbone > 0 && r.stress_error < 10 * c.stress_error && r.kinetic_energy < nearly * c.kinetic_energy;
  const bool window_ends = now.step() % watch_.window_length() == 0;
  if (window_ends) slow_windows_ = slow ? slow_windows_ + 1 : std::max<std::int64_t>(slow_windows_ - 1, 0);
  const bool near =
      r.force_imbalance < nearly * c.force_imbalance && r.strain_drift < nearly * c.strain_drift;
  const double moving = motion(now);
  peak_ = std::max(peak_, moving);
  const bool timely = count_ < often ? window_ends : moving < of_its_peak * peak_;
  return timely && slow && (near || slow_windows_ > patience);
}

std::string Quench::memory() {
  std::array<char, 32> peak{};  // the shortest text that gives the same bits
  std::to_chars(peak.data(), peak.data() + peak.size(), peak_);
  return std::to_string(count_) + ' ' + std::to_string(slow_windows_) + ' ' + peak.data();
}

void Quench::recall(const std::string& memory) {
  if (memory.empty()) return;
  const auto first = memory.find(' '), last = memory.rfind(' ');
  if (first == last)
    throw InputError("a run remembers \"" + memory + "\" where it must remember three numbers");
  count_ = recalled_count(memory.substr(0, first));
  slow_windows_ = recalled_count(memory.substr(first + 1, last - first - 1));
  const char* const end = memory.data() + memory.size();
  const auto [rest, error] = std::from_chars(memory.data() + last + 1, end, peak_);
  if (error != std::errc{} || rest != end || !(peak_ >= 0))
    throw InputError("a run remembers \"" + memory + "\" where it must remember an energy");
}

std::optional<Verdict> Quench::fire(Observation& now) {
  Packing packing = now.take_packing();
  for (std::size_t k = 0; k < packing.size(); ++k) {
    packing.ledger.quenched += kinetic_energy(packing, k);
    packing.velocity[k] = packing.spin[k] = {};
  }
  packing.cell.rate = {};
  now.replace(packing);
  peak_ = 0;
  ++count_;
  return {};
}

}  // namespace furnas
