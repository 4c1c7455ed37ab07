#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/simulation.h"
#include "engine/state/measures.h"

namespace furnas {

/// How a run ended. Only `jammed` gives a phi_J; `settled` gives phi with a bound on its further change.
enum class Verdict { jammed, settled, budget, diverged, interrupted };

/// The verdict as it is written to files: "jammed", "settled", "budget", "diverged", "interrupted".
const char* to_string(Verdict verdict);

/// What events read between steps: the packing and its measures. Each is computed on request, at most once a
/// step.
class Observation {
 public:
  /// `replaced`: what replaced() returned at the end of an earlier part of the run.
  Observation(Simulation& simulation, int backbone_threshold, std::int64_t replaced = 0)
      : simulation_(simulation), backbone_threshold_(backbone_threshold), replaced_(replaced) {}

  Simulation& simulation() { return simulation_; }
  std::int64_t step() const { return simulation_.step(); }
  const Packing& packing();    ///< as it is between two steps
  const Measures& measures();  ///< of that packing
  /// Moves the packing to the caller, who may change it without making a copy. A later request takes the
  /// packing from the simulation again.
  Packing take_packing();

  /// Continues the run with a changed packing. Throws NumericalFailure if the changed packing is not valid.
  void replace(const Packing& packing);
  /// Takes out all motion of the particles and of the cell.
  void stop_all_motion();
  /// How often events have called replace() or stop_all_motion() since the run began.
  std::int64_t replaced() const { return replaced_; }

  /// How often events have computed all forces, besides those of the steps, since this Observation began.
  std::int64_t evaluations() const { return evaluations_; }
  void count_evaluations(std::int64_t more) { evaluations_ += more; }

  /// The verdict of an event that has found a fault; `sentence` describes the fault.
  Verdict diverged(std::string sentence) {
    fault_ = std::move(sentence);
    return Verdict::diverged;
  }
  /// What made the run diverge; empty if nothing did.
  const std::string& fault() const { return fault_; }

 private:
  void refresh();

  Simulation& simulation_;
  int backbone_threshold_;
  std::int64_t taken_at_ = -1;
  std::int64_t replaced_;
  std::int64_t evaluations_ = 0;
  std::string fault_;
  std::optional<Packing> packing_;
  std::optional<Measures> measures_;
};

/// Something that can happen between two steps of a run. Events act one after the other and may change any
/// part of the simulation.
class Event {
 public:
  virtual ~Event() = default;
  virtual const char* name()
      const = 0;  ///< in progress lines; also the key of saved() in checkpoints, so keep it

  /// The first step after `step` at which the event may be due; `step` itself if the event is overdue.
  virtual std::int64_t next(std::int64_t step) const = 0;

  /// Whether the event happens now; called at the steps that next() returned.
  virtual bool due(Observation&) { return true; }

  /// Whether due() is also called at the first step after `attention` of compact() was set. Only for events
  /// that do not change the state: no result may depend on when `attention` was set.
  virtual bool heeds_attention() const { return false; }

  /// Carries out the event. A returned verdict ends the run.
  virtual std::optional<Verdict> fire(Observation& now) = 0;

  /// What the event needs to know when the run stops now and continues in another process. After the call
  /// everything that the event has written is on the disk.
  virtual std::string saved() { return {}; }

  /// Restores what saved() returned; called once, before all other members. The text is empty at the
  /// beginning of a run. Throws InputError if the event cannot continue from the text.
  virtual void restore(const std::string&) {}
};

/// The count in a text written by std::to_string(); 0 for the empty text at the beginning of a run. Throws
/// InputError if the text is no count.
std::int64_t saved_count(const std::string& saved);

/// The first multiple of `period` after `step`.
std::int64_t next_multiple(std::int64_t step, std::int64_t period);

/// The events of a run. Events that are due at the same step happen in this order.
using Events = std::vector<std::unique_ptr<Event>>;

/// Alternates between steps and events until an event ends the run. When `attention` is set, the run calls
/// due() of all events with heeds_attention() after the current step, and then clears `attention`.
Verdict compact(Observation& now, const Events& events, std::atomic<bool>* attention = nullptr);

}  // namespace furnas
