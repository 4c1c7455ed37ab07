#include "engine/events/minimize.h"

#include <algorithm>

#include "engine/base/numbers.h"
#include "engine/base/parallel.h"
#include "engine/base/require.h"
#include "engine/minimize/find_minimum.h"
#include "engine/monitor/energy.h"

namespace furnas {
namespace {

/// Whether the packing is left to the time steps for longer (docs/developer/decisions/minimizer.md): its
/// backbone is large, or so many spheres touch that the small ones between a few large ones all but jam.
bool is_large(std::int64_t backbone, std::size_t contacts) {
  constexpr std::int64_t large_backbone = 1500;
  constexpr std::size_t many_contacts = 20'000;
  return backbone >= large_backbone || contacts >= many_contacts;
}

constexpr double near_the_bath = 0.05;  // stress error, as in RestReport

/// Whether the packing has a backbone, a stress near the bath's, and little kinetic energy. In a large
/// packing the forces must nearly balance, too.
bool has_found_its_basin(const RestReport& r, const Measures& m) {
  constexpr double motion = 0.05;  // kinetic energy/energy of the contacts
  constexpr double imbalance = 0.003;
  return r.backbone > 0 && r.stress_error < near_the_bath && m.energy.kinetic < motion * m.energy.normal &&
         (!is_large(r.backbone, static_cast<std::size_t>(m.contacts)) || r.force_imbalance < imbalance);
}

bool is_balanced(const RestReport& r, const RestCriteria& c) {
  return r.kinetic_energy < c.kinetic_energy && r.stress_error < c.stress_error &&
         r.force_imbalance < c.force_imbalance;
}

/// Number of evaluations that take one or two seconds on one core, within bounds.
std::int64_t evaluations_for(std::size_t particles) {
  return std::clamp<std::int64_t>(20'000'000 / static_cast<std::int64_t>(particles), 1000, 10'000);
}

}  // namespace

std::int64_t Minimize::next(std::int64_t step) const {
  return searching() || (pressures_ && pressures_->last_change() == step)
             ? step + 1
             : next_multiple(step, watch_.period());
}

bool Minimize::due(Observation& now) {
  const Barostat& bath = now.simulation().model().barostat;
  if (bath.pressure != pressure_) {
    search_ = bath.pressure < pressure_ ? Search::unloading : Search::none;
    pressure_ = bath.pressure;
    spent_ = 0;
    not_before_ = 0;
  }
  if (search_ == Search::unloading && spent_ > 0 && stress_error(now.measures(), bath) < near_the_bath) {
    search_ = Search::none;
    spent_ = 0;
  }
  if (searching()) return true;
  if (now.step() % watch_.period() != 0) return false;
  const RestReport& r = watch_.look(now);
  return now.step() >= not_before_ && !r.resting && has_found_its_basin(r, now.measures()) &&
         !is_balanced(r, watch_.criteria());
}

std::optional<Verdict> Minimize::fire(Observation& now) {
  constexpr std::int64_t pause = 5;  // windows
  const Model& model = now.simulation().model();
  Packing p = now.take_packing();
  const bool large = is_large(watch_.report().backbone, p.contacts.size());
  const std::int64_t patience = large ? 20'000 : 50'000;  // evaluations
  const auto enthalpy_and_motion = [&] {
    return energy(p, model.law).total() + model.barostat.pressure * p.cell.volume();
  };
  const double before = enthalpy_and_motion(), volume = p.cell.volume();
  MinimumReport report;
  Workers(now.simulation().threads()).run([&] {
    Enthalpy enthalpy(p, model.law, model.barostat);
    report = find_minimum(enthalpy, in_a_call_ > 0 ? in_a_call_ : evaluations_for(p.size()));
    enthalpy.put_into(p);
  });
  p.ledger.quenched += before - enthalpy_and_motion();
  p.ledger.cell_work += model.barostat.pressure * (volume - p.cell.volume());
  now.replace(p);
  evaluations_ += report.evaluations;
  spent_ += report.evaluations;
  now.count_evaluations(report.evaluations);
  const bool ended = report.reached || report.stuck;
  if (ended || spent_ >= patience)
    search_ = Search::none;
  else if (!searching())
    search_ = Search::minimum;
  if (!searching()) {
    not_before_ = now.step() + (ended ? 1 : pause) * watch_.window_length();
    spent_ = 0;
  }
  return {};
}

std::string Minimize::saved() {
  return exact_text(evaluations_, static_cast<int>(search_), pressure_, spent_, not_before_);
}

void Minimize::restore(const std::string& saved) {
  if (saved.empty()) return;
  int search{};
  const bool read = Numbers(saved).take_all(evaluations_, search, pressure_, spent_, not_before_);
  if (!read || evaluations_ < 0 || search < 0 || search > static_cast<int>(Search::unloading) ||
      !(pressure_ >= 0) || spent_ < 0 || not_before_ < 0)
    throw InputError("a run remembers \"" + saved +
                     "\" where it must remember how far a search for a minimum is");
  search_ = static_cast<Search>(search);
}

}  // namespace furnas
