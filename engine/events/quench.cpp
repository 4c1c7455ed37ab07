#include "engine/events/quench.h"

#include <algorithm>
#include <cmath>

#include "engine/base/numbers.h"
#include "engine/base/require.h"

namespace furnas {
namespace {

constexpr std::size_t looks_judged = 10;  // those of a window

}  // namespace

/// Whether the geometric mean of the later five energies is well above that of the earlier five. Knocks of
/// rattlers scatter by more than a slow growth, but a growth that lasts is seen at one of the next windows.
bool Quench::growing() const {
  const auto half = static_cast<std::ptrdiff_t>(looks_judged / 2);
  const auto sum_of_logarithms = [](auto first, auto last) {
    double sum = 0;
    for (; first != last; ++first) sum += std::log(std::max(*first, 1e-300));
    return sum;
  };
  const double early = sum_of_logarithms(energies_.begin(), energies_.begin() + half);
  const double late = sum_of_logarithms(energies_.begin() + half, energies_.end());
  return late - early > static_cast<double>(half) * std::log(watch_.criteria().growth);
}

bool Quench::due(Observation& now) {
  constexpr double slowly = 100, of_stress = 10;  // times the limits; the cell follows the stress at once
  constexpr std::int64_t patience = 50;           // [windows]
  if (const double pressure = now.simulation().model().barostat.pressure; pressure != pressure_) {
    pressure_ = pressure;
    slow_windows_ = 0;
    energies_.clear();
  }
  const RestReport& r = watch_.look(now);
  const RestCriteria& c = watch_.criteria();
  energies_.push_back(r.kinetic_energy);
  if (energies_.size() > looks_judged) energies_.pop_front();
  if (now.step() % watch_.window_length() != 0) return false;
  steady_ = energies_.size() == looks_judged && !growing();

  const bool pressed = r.backbone > 0 && r.stress_error < of_stress * c.stress_error;
  const bool slow = pressed && r.kinetic_energy < slowly * c.kinetic_energy;
  slow_windows_ = slow ? slow_windows_ + 1 : std::max<std::int64_t>(slow_windows_ - 1, 0);
  const bool near = pressed && r.force_imbalance < c.stilling * c.force_imbalance &&
                    r.strain_drift < c.stilling * c.strain_drift;
  // What moves though forces balance is felt by no contact: a bridge that spins.
  const bool unfelt = r.stress_error < c.stress_error && r.force_imbalance < c.force_imbalance;
  const bool cold = r.kinetic_energy < c.stilling_energy * c.kinetic_energy;
  const bool still = near && (cold || unfelt);
  const bool in_vain = slow && slow_windows_ > patience;
  return c.stilling > 0 && steady_ && (still || in_vain);
}

std::string Quench::saved() {
  std::string text = exact_text(count_, pressure_, slow_windows_);
  for (const double energy : energies_) text.append(1, ' ').append(exact_text(energy));
  return text;
}

void Quench::restore(const std::string& saved) {
  if (saved.empty()) return;
  const auto refuse = [&] {
    throw InputError("a run remembers \"" + saved +
                     "\" where it must remember a count, a pressure, a count of "
                     "windows and up to ten energies, all from 0 on");
  };
  Numbers numbers(saved);
  if (!numbers.take(count_, pressure_, slow_windows_) || count_ < 0 || !(pressure_ >= 0) || slow_windows_ < 0)
    refuse();
  energies_.clear();
  while (numbers.more()) {
    double energy = 0;
    if (!numbers.take(energy) || !(energy >= 0) || energies_.size() == looks_judged) refuse();
    energies_.push_back(energy);
  }
}

std::optional<Verdict> Quench::fire(Observation& now) {
  // What the step has kept of the motion, its stress and half a step of its losses, acts once more.
  now.stop_all_motion();
  energies_.clear();
  ++count_;
  return {};
}

}  // namespace furnas
