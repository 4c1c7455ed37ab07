#include "engine/events/settle.h"

#include <algorithm>
#include <utility>

#include "engine/base/numbers.h"
#include "engine/base/require.h"
#include "engine/laws/any_law.h"
#include "engine/monitor/measure.h"

namespace furnas {
namespace {

PhiRecord::Span joined(const PhiRecord::Span& a, const PhiRecord::Span& b) {
  return {a.looks + b.looks, std::max(a.end, b.end), std::min(a.low, b.low), std::max(a.high, b.high),
          std::max(a.stress_error, b.stress_error)};
}

/// Change of phi if the stress took the value of the bath.
double change_by_stress(double phi, double unloading_strain, double stress_error) {
  constexpr double softer = 3;  // times softer than if all contacts followed the cell's strain
  return softer * 3 * phi * unloading_strain * stress_error;
}

}  // namespace

void PhiRecord::add(std::int64_t step, double phi, double stress_error) {
  const Span look{1, step, phi, phi, stress_error};
  if (!spans_.empty() && spans_.back().looks < spans_.front().looks) {
    spans_.back() = joined(spans_.back(), look);
    return;
  }
  if (spans_.size() == most_spans) {
    for (std::size_t k = 0; k < most_spans / 2; ++k) spans_[k] = joined(spans_[2 * k], spans_[2 * k + 1]);
    spans_.resize(most_spans / 2);
  }
  spans_.push_back(look);
}

PhiRecord::Span PhiRecord::since(std::int64_t step) const {
  require(!empty(), "a record of phi is asked for what it has seen");
  Span all = spans_.back();
  for (const Span& span : spans_)
    if (span.end > step) all = joined(all, span);
  return all;
}

void Settle::record(Observation& now, const RestReport& r, double phi) {
  constexpr double carries = 0.1, has_lost_it = 0.5;  // stress errors, as in RestReport
  if (loaded_at_ < next_.last_change()) past_.clear();
  if (past_.empty()) {
    if (r.backbone == 0 || !(r.stress_error < carries)) return;
    loaded_at_ = now.step();
  } else if (r.backbone == 0 || r.stress_error > has_lost_it) {
    past_.clear();
    return;
  }
  past_.add(now.step(), phi, r.stress_error);
}

/// How many times the range of phi over the later half of the age a bound allows for; 0 where the packing is
/// too far from rest for a bound. A packing rearranges less when its pressure has fallen, so that five times
/// the range are enough at a pressure that is not the last.
double Settle::ranges_allowed(const RestReport& r, bool friction) const {
  constexpr double of_stress = 10, of_balance = 100, of_energy = 100;  // multiples of the limits
  constexpr double doublings = 5, rearrangements = 20;
  const RestCriteria& c = watch_.criteria();
  if (r.backbone == 0 || !(r.stress_error < of_stress * c.stress_error)) return 0;
  if (r.force_imbalance < of_balance * c.force_imbalance && r.kinetic_energy < of_energy * c.kinetic_energy)
    return doublings;
  if (friction) return 0;
  return next_.is_last() ? rearrangements : doublings;
}

bool Settle::due(Observation& now) {
  const RestReport& r = watch_.look(now);
  const double phi = now.measures().phi;
  record(now, r, phi);
  // A packing at rest that is still here waits for its final quenches.
  if (now.step() % watch_.window_length() != 0 || r.resting) return false;
  const std::int64_t age = now.step() - loaded_at_;
  bound_ = RestReport::unknown;
  const AnyLaw& law = now.simulation().model().law;
  const double ranges = ranges_allowed(r, has_friction(law));
  if (past_.empty() || age < least_age_ || ranges == 0 || !quench_.steady()) return false;
  const PhiRecord::Span late = past_.since(now.step() - age / 2);
  const double carried = next_.carried_bound();
  bound_ = carried + ranges * (late.high - late.low) +
           change_by_stress(phi, unloading_strain(now.packing(), law), late.stress_error);
  // Where pressures follow, a third of phi_error is left to them.
  const double share = next_.is_last() ? 1 : 2.0 / 3;
  return bound_ - carried < share * (watch_.criteria().phi_error - carried);
}

std::optional<Verdict> Settle::fire(Observation& now) {
  if (next_.is_last()) return Verdict::settled;
  next_.go_on(now, bound_);
  bound_ = RestReport::unknown;
  return {};
}

std::string Settle::saved() {
  std::string text = exact_text(loaded_at_, bound_);
  for (const PhiRecord::Span& s : past_.spans())
    text.append(1, ' ').append(exact_text(s.looks, s.end, s.low, s.high, s.stress_error));
  return text;
}

void Settle::restore(const std::string& saved) {
  if (saved.empty()) return;
  Numbers numbers(saved);
  bool read = numbers.take(loaded_at_, bound_) && loaded_at_ >= 0 && bound_ >= 0;
  std::vector<PhiRecord::Span> spans;
  for (PhiRecord::Span s; read && numbers.more(); spans.push_back(s))
    read = numbers.take(s.looks, s.end, s.low, s.high, s.stress_error) && s.looks > 0 && s.low <= s.high;
  if (!read || spans.size() > PhiRecord::most_spans)
    throw InputError("a run remembers \"" + saved.substr(0, 200) +
                     "\" where it must remember a step, a bound, and up to " +
                     std::to_string(PhiRecord::most_spans) +
                     " spans of looks with a step, two fractions and an error of the stress");
  past_.restore(std::move(spans));
}

}  // namespace furnas
