#include "engine/events/at_rest.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "engine/base/numbers.h"
#include "engine/base/require.h"

namespace furnas {

double stress_error(const Measures& m, const Barostat& bath) {
  const double p = bath.pressure;
  if (bath.freedom == CellFreedom::cubic) return std::abs(m.pressure - p) / p;
  double error = 0;
  for (std::size_t k = 0; k < 3; ++k) error = std::max(error, std::abs(m.stress[k] - p) / p);
  if (bath.freedom == CellFreedom::triclinic)
    for (std::size_t k = 3; k < 6; ++k) error = std::max(error, std::abs(m.stress[k]) / p);
  return error;
}

const RestReport& RestWatch::look(Observation& now) {
  if (!window_.empty() && window_.back().step == now.step()) return report_;
  const Measures& m = now.measures();
  report_ = {};
  report_.backbone = m.backbone().backbone;
  report_.stress_error = stress_error(m, now.simulation().model().barostat);
  report_.force_imbalance = m.force_imbalance;
  report_.kinetic_energy = criteria_.kinetic_energy_alone ? m.kinetic_energy : m.backbone_kinetic_energy;

  report_.largest_overlap = m.largest_overlap;
  const bool slow = report_.kinetic_energy < criteria_.kinetic_energy && report_.backbone > 0 &&
                    m.largest_overlap < criteria_.largest_overlap;
  const bool balanced = report_.stress_error < criteria_.stress_error;
  const auto holds = [&](double imbalance) {
    return slow && (criteria_.kinetic_energy_alone || (balanced && report_.force_imbalance < imbalance));
  };
  window_.push_back({now.step(), m.cell.edges, holds(criteria_.force_imbalance),
                     holds(std::max(criteria_.loose_imbalance, criteria_.force_imbalance))});
  if (static_cast<std::int64_t>(window_.size()) > patience + 1) window_.pop_front();
  judge();
  return report_;
}

/// Decides from the looks whether the packing rests.
void RestWatch::judge() {
  // Over ten windows oscillations of the cell contribute less to the drift; over one window earlier motion is
  // forgotten sooner. The smaller drift counts.
  report_.strain_drift = std::min(drift_over(looks), drift_over(patience));
  const bool steady = criteria_.kinetic_energy_alone || report_.strain_drift < criteria_.strain_drift;
  const bool tightly = steady && all_hold(&Look::holds, looks + 1);
  report_.loosely = !tightly && steady && all_hold(&Look::holds_loosely, patience + 1);
  report_.resting = tightly || report_.loosely;
  report_.waiting_for = furthest();
}

RestWatch::Saved RestWatch::saved() const {
  return {window_, report_.backbone, report_.stress_error, report_.force_imbalance, report_.kinetic_energy};
}

void RestWatch::restore(Saved saved) {
  window_ = std::move(saved.window);
  report_ = {};
  report_.backbone = saved.backbone;
  report_.stress_error = saved.stress_error;
  report_.force_imbalance = saved.force_imbalance;
  report_.kinetic_energy = saved.kinetic_energy;
  if (!window_.empty()) judge();
}

double RestWatch::drift_over(std::int64_t count) const {
  if (static_cast<std::int64_t>(window_.size()) <= count) return std::numeric_limits<double>::infinity();
  const Look& then = *(window_.end() - 1 - count);
  const Look& now = window_.back();
  return strain_between(then.edges, now.edges) * drift_steps_ / static_cast<double>(now.step - then.step);
}

bool RestWatch::all_hold(bool Look::*holds, std::int64_t count) const {
  return static_cast<std::int64_t>(window_.size()) >= count &&
         std::all_of(window_.end() - count, window_.end(), [&](const Look& l) { return l.*holds; });
}

std::string RestWatch::furthest() const {
  if (report_.resting) return {};
  struct Candidate {
    const char* name;
    double share;
  };
  std::array<Candidate, 5> candidates{
      {{"kinetic energy", report_.kinetic_energy / criteria_.kinetic_energy},
       {"smaller overlaps", report_.largest_overlap / criteria_.largest_overlap},
       {"stress", report_.stress_error / criteria_.stress_error},
       {"force balance", report_.force_imbalance / criteria_.force_imbalance},
       {"strain drift", report_.strain_drift / criteria_.strain_drift}}};
  if (report_.backbone == 0) return "a backbone";
  const std::size_t count = criteria_.kinetic_energy_alone ? 2 : candidates.size();
  // The drift is not known, and infinite, before a full window.
  const Candidate* worst = nullptr;
  for (std::size_t k = 0; k < count; ++k)
    if (std::isfinite(candidates[k].share) && (!worst || candidates[k].share > worst->share))
      worst = &candidates[k];
  return worst && worst->share >= 1 ? worst->name : "the window";
}

RestingState resting_state(double pressure, std::int64_t step, const Measures& measures, double phi_bound) {
  const RattlerCount& backbone = measures.backbone();
  return {pressure, measures.phi, step, backbone.coordination, backbone.large, backbone.small, phi_bound};
}

std::int64_t AtRest::next(std::int64_t step) const {
  return quenching() ? begun_ + done_ * spacing_ : next_multiple(step, watch_.period());
}

bool AtRest::due(Observation& now) {
  if (quenching()) return true;
  const bool resting = watch_.look(now).resting;
  if (!resting) done_ = 0;
  return resting;
}

std::optional<Verdict> AtRest::fire(Observation& now) {
  if (done_ == watch_.criteria().final_quenches) return Verdict::jammed;
  if (done_ == 0) begun_ = now.step();
  now.stop_all_motion();
  ++done_;
  ++count_;
  return {};
}

std::string AtRest::saved() {
  if (count_ == 0) return {};
  return exact_text(done_, begun_, count_);
}

void AtRest::restore(const std::string& saved) {
  if (saved.empty()) return;
  const bool read = Numbers(saved).take_all(done_, begun_, count_);
  if (!read || done_ < 0 || done_ > watch_.criteria().final_quenches || begun_ < 0 || count_ < done_)
    throw InputError("a run remembers \"" + saved + "\" where it must remember its final quenches");
}

bool NextPressure::due(Observation& now) { return !is_last() && watch_.look(now).resting; }

std::optional<Verdict> NextPressure::fire(Observation& now) {
  go_on(now, 0);
  return {};
}

void NextPressure::go_on(Observation& now, double phi_bound) {
  require(!is_last(), "a run goes on to a further pressure of its list");
  reached_.push_back(
      resting_state(now.simulation().model().barostat.pressure, now.step(), now.measures(), phi_bound));
  now.simulation().set_bath(baths_.front());
  baths_.erase(baths_.begin());
  watch_.restart();
}

}  // namespace furnas
