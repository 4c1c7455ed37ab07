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

/// How a run ended. Only `jammed` gives a phi_J; `settled` gives phi with a bound on what it may still
/// change.
enum class Verdict { jammed, settled, budget, diverged, interrupted };

/// The verdict as it stands in files: "jammed", "settled", "budget", "diverged", "interrupted".
const char* to_string(Verdict verdict);

/// What events look at between steps: the packing and its measures, taken once a step and only when asked.
class Observation {
 public:
  /// `replaced` counts what an earlier part of the run has replaced.
  Observation(Simulation& simulation, int backbone_threshold, std::int64_t replaced = 0)
      : simulation_(simulation), backbone_threshold_(backbone_threshold), replaced_(replaced) {}

  Simulation& simulation() { return simulation_; }
  std::int64_t step() const { return simulation_.step(); }
  const Packing& packing();    ///< as it is between the steps
  const Measures& measures();  ///< of that packing
  /// The packing, given away: whoever changes it needs no second one. Asked again, it is taken anew.
  Packing take_packing();

  /// Puts a changed packing in the place of the running one. Throws NumericalFailure if it is none any more.
  void replace(const Packing& packing);
  /// Takes out all motion of the particles and of the cell.
  void stop_all_motion();
  /// How often an event has changed the packing so since the run began.
  std::int64_t replaced() const { return replaced_; }

  /// The verdict of an event that has seen what must not be, with a sentence that says what.
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
  std::string fault_;
  std::optional<Packing> packing_;
  std::optional<Measures> measures_;
};

/// Something that can happen between two steps of a run. Events act serially and may touch anything.
class Event {
 public:
  virtual ~Event() = default;
  virtual const char* name()
      const = 0;  ///< in progress lines, and the key of saved() in checkpoints: a change breaks them

  /// The first step after `step` at which it may be due.
  virtual std::int64_t next(std::int64_t step) const = 0;

  /// Whether it happens now; asked at the steps that `next` named.
  virtual bool due(Observation&) { return true; }

  /// Whether it is asked, too, as soon as the run is called to attention, at whatever step that is. Only for
  /// what leaves the state alone: a run must not depend on when somebody called.
  virtual bool heeds_attention() const { return false; }

  /// Lets it happen; an answer ends the run.
  virtual std::optional<Verdict> fire(Observation& now) = 0;

  /// What it must know again when the run is stopped now and goes on in another process; what it has written
  /// so far is then on the disk.
  virtual std::string saved() { return {}; }

  /// Takes up what saved() gave, once and before all else. Empty at the beginning of a run. Throws
  /// InputError if it cannot go on from there.
  virtual void restore(const std::string&) {}
};

/// A count as std::to_string() wrote it; 0 for the empty text of a beginning. Throws InputError.
std::int64_t saved_count(const std::string& saved);

/// The first multiple of `period` after `step`.
std::int64_t next_multiple(std::int64_t step, std::int64_t period);

/// The events of a run, in the order in which those of one step happen.
using Events = std::vector<std::unique_ptr<Event>>;

/// Runs from event to event until one of them ends it. Setting `attention` makes the run ask the events that
/// heed it after the current step; the run clears it.
Verdict compact(Observation& now, const Events& events, std::atomic<bool>* attention = nullptr);

}  // namespace furnas
