#include "engine/compaction.h"

#include <algorithm>

#include "engine/base/numbers.h"
#include "engine/base/require.h"
#include "engine/monitor/energy.h"
#include "engine/monitor/measure.h"

namespace furnas {

const char* to_string(Verdict verdict) {
  switch (verdict) {
    case Verdict::jammed:
      return "jammed";
    case Verdict::settled:
      return "settled";
    case Verdict::budget:
      return "budget";
    case Verdict::diverged:
      return "diverged";
    case Verdict::interrupted:
      return "interrupted";
  }
  return "";
}

void Observation::refresh() {
  if (taken_at_ == simulation_.step()) return;
  taken_at_ = simulation_.step();
  packing_.reset();
  measures_.reset();
}

const Packing& Observation::packing() {
  refresh();
  if (!packing_) packing_ = simulation_.packing();
  return *packing_;
}

Packing Observation::take_packing() {
  packing();
  return *std::exchange(packing_, std::nullopt);
}

const Measures& Observation::measures() {
  refresh();
  if (!measures_) {
    measures_ = measure(packing(), backbone_threshold_);
    measures_->rebuilds = simulation_.neighbours().builds;
    measures_->energy = energy(packing(), simulation_.model().law);
    measures_->ledger = packing().ledger;
  }
  return *measures_;
}

void Observation::replace(const Packing& packing) {
  taken_at_ = -1;
  ++replaced_;
  try {
    simulation_.load(packing);
  } catch (const InputError& error) {
    throw NumericalFailure(error.what());  // no input error: the run itself led to this packing
  }
}

void Observation::stop_all_motion() {
  const std::vector<Vec3<double>> none(packing().size());
  simulation_.set_motion(none, none, {});
  taken_at_ = -1;
  ++replaced_;
}

std::int64_t saved_count(const std::string& saved) {
  if (saved.empty()) return 0;
  const std::optional<std::int64_t> count = number_in<std::int64_t>(saved);
  if (!count || *count < 0)
    throw InputError("a run remembers \"" + saved + "\" where it must remember a count");
  return *count;
}

std::int64_t next_multiple(std::int64_t step, std::int64_t period) { return (step / period + 1) * period; }

Verdict compact(Observation& now, const Events& events, std::atomic<bool>* attention) {
  require(!events.empty(), "a run needs an event that ends it");
  std::vector<std::int64_t> next(events.size());
  while (true) {
    // An event may be due sooner because of what a later one has done, as when the pressure changes.
    for (std::size_t k = 0; k < events.size(); ++k) next[k] = events[k]->next(now.step());
    const std::int64_t target = *std::min_element(next.begin(), next.end());
    now.simulation().advance(target - now.step(), attention);
    const bool called = attention && attention->exchange(false);
    for (std::size_t k = 0; k < events.size(); ++k) {
      if (next[k] > now.step() && !(called && events[k]->heeds_attention())) continue;
      if (events[k]->due(now))
        if (const std::optional<Verdict> verdict = events[k]->fire(now)) return *verdict;
    }
  }
}

}  // namespace furnas
