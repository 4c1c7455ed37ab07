#include "engine/events/quench.h"

#include <algorithm>
#include <cmath>

#include "engine/base/numbers.h"
#include "engine/base/require.h"

namespace furnas {
namespace {

constexpr std::size_t looks_judged = 10;  // the looks of one window

}  // namespace

/// Whether the geometric mean of the last five energies exceeds that of the first five by more than
/// criteria.growth. Impacts of rattlers make the energies scatter by more than a slow growth within one
/// window, but a lasting growth is detected in one of the next windows.
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
  constexpr double slowly = 100, of_stress = 10;  // times the limits; the cell quickly relaxes the stress
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
  // If the forces balance, no contact feels the motion that is left, for example the spin of a bridge.
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
  // The kinetic part of the stress and half of the last losses belong to the motion before the quench. They
  // still enter the next step.
  now.stop_all_motion();
  energies_.clear();
  ++count_;
  return {};
}

}  // namespace furnas
