#include "engine/protocol/run.h"

#include <string>
#include <utility>

#include "engine/base/require.h"
#include "engine/events/flip.h"
#include "engine/events/minimize.h"
#include "engine/events/quench.h"
#include "engine/events/settle.h"
#include "engine/monitor/faults.h"

namespace furnas {
namespace {

Rhythm rhythm_of(const Protocol& protocol, const Packing& start) {
  return Rhythm(relative_time_step(protocol, smallest_kept_diameter(protocol, start)));
}

template <class E>
const E* find(const Events& events) {
  for (const auto& event : events)
    if (const auto* found = dynamic_cast<const E*>(event.get())) return found;
  return nullptr;
}

template <class E>
std::int64_t count_of(const Events& events) {
  const E* const event = find<E>(events);
  return event ? event->count() : 0;
}

}  // namespace

ProtocolRun::ProtocolRun(const Protocol& protocol, const Packing& start, int threads)
    : ProtocolRun(protocol, start, threads, {}) {
  goes_on_ = false;
}

ProtocolRun::ProtocolRun(const Protocol& protocol, const Packing& reached, int threads, const RunState& past)
    : protocol_(protocol),
      baths_(baths_of(protocol, reached)),
      rhythm_(rhythm_of(protocol, reached)),
      simulation_(make_simulation(model_of(protocol, reached), reached, threads)),
      now_(*simulation_, backbone_threshold(simulation_->model().law), past.replaced),
      watch_(protocol.rest, rhythm_),
      reached_(past.reached),
      past_(past),
      goes_on_(true) {
  watch_.restore(past.watch);
  if (reached_.size() >= baths_.size())
    throw InputError("the packing has come to rest at " + std::to_string(reached_.size()) +
                     " pressures, and the case has " + std::to_string(baths_.size()));
  if (!reached_.empty()) simulation_->set_bath(baths_[reached_.size()]);
}

void ProtocolRun::begin(Onlookers onlookers) {
  require(events_.empty(), "a run begins once");
  const auto next = static_cast<std::ptrdiff_t>(1 + reached_.size());
  events_ = schedule(protocol_, rhythm_, {baths_.begin() + next, baths_.end()}, watch_, reached_,
                     std::move(onlookers));
  for (const auto& event : events_) {
    const auto saved = past_.events.find(event->name());
    event->restore(saved == past_.events.end() ? std::string() : saved->second);
  }
}

Outcome ProtocolRun::compact_on(std::atomic<bool>* attention) {
  const Verdict verdict = compact(now_, events_, attention);
  if (verdict == Verdict::diverged) return {verdict, now_.fault(), false};
  const std::string fault = fault_of(now_.packing(), simulation_->model());
  if (fault.empty()) return {verdict, {}};
  // In an uninterrupted run the Monitor checks for faults at its own steps. A run that is stopped in between
  // must not end with another verdict.
  const bool stopped =
      verdict == Verdict::interrupted || (verdict == Verdict::budget && now_.step() < protocol_.steps);
  if (stopped) return {verdict, {}, false};
  return {Verdict::diverged, fault, false};
}

/// A NumericalFailure, within a step or after it, is an outcome of the run, too.
Outcome ProtocolRun::go(std::atomic<bool>* attention) {
  try {
    return compact_on(attention);
  } catch (const NumericalFailure& error) {
    return {Verdict::diverged, std::string(error.what()) + ", at step " + std::to_string(now_.step()), false};
  }
}

RunState ProtocolRun::state() const {
  RunState state{reached_, watch_.saved(), {}, now_.replaced(), lists_built()};
  for (const auto& event : events_)
    if (std::string saved = event->saved(); !saved.empty()) state.events[event->name()] = std::move(saved);
  return state;
}

std::vector<RestingState> ProtocolRun::reached(Verdict verdict) {
  std::vector<RestingState> all = reached_;
  if (verdict == Verdict::jammed || verdict == Verdict::settled)
    all.push_back(resting_state(simulation_->model().barostat.pressure, now_.step(), now_.measures(),
                                verdict == Verdict::settled ? phi_bound() : 0));
  return all;
}

std::int64_t ProtocolRun::lists_built() const {
  // A resumed run builds a list at its beginning, which the uninterrupted run would not build; it is not
  // counted.
  return past_.lists_built + simulation_->neighbours().builds - (goes_on_ ? 1 : 0);
}

std::int64_t ProtocolRun::quenches() const { return count_of<Quench>(events_) + count_of<AtRest>(events_); }
std::int64_t ProtocolRun::evaluations() const {
  const auto* const event = find<Minimize>(events_);
  return event ? event->evaluations() : 0;
}
double ProtocolRun::phi_bound() const {
  const auto* const event = find<Settle>(events_);
  return event ? event->bound() : RestReport::unknown;
}
std::int64_t ProtocolRun::flips() const { return count_of<Flip>(events_); }

Packing ProtocolRun::take_packing() {
  Packing packing = now_.take_packing();
  events_.clear();
  simulation_.reset();
  return packing;
}

std::optional<double> Jam::phi_J() const {
  if (verdict != Verdict::jammed) return {};
  return measures.phi;
}

Jam jam(const Packing& start, const Protocol& protocol, int threads) {
  ProtocolRun run(protocol, start, threads > 0 ? threads : threads_for(start.size()));
  run.begin();
  Outcome outcome = run.go();
  Jam end{outcome.verdict,      std::move(outcome.fault), {},
          run.now().measures(), run.watch().report(),     run.reached(outcome.verdict)};
  end.packing = run.take_packing();
  return end;
}

}  // namespace furnas
