#pragma once

#include <atomic>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/compaction.h"
#include "engine/protocol/protocol.h"
#include "engine/protocol/schedule.h"

namespace furnas {

/// What is needed to resume a stopped run, besides its packing and its protocol.
struct RunState {
  std::vector<RestingState> reached;          ///< pressures at which the packing came to rest or settled
  RestWatch::Saved watch;                     ///< the state of RestWatch
  std::map<std::string, std::string> events;  ///< what each event has saved, by the name of the event
  std::int64_t replaced{};                    ///< how often events had changed the packing
  std::int64_t lists_built{};                 ///< neighbour lists built so far
};

/// How a run ended.
struct Outcome {
  Verdict verdict;
  std::string fault;     ///< what made it diverge, in a sentence; empty if nothing did
  bool is_sound = true;  ///< the packing has no fault, so a run can continue from it
};

/// The run of a packing through a protocol. The run itself reads and writes no files; a program can add
/// events that write files. A run may be used by one thread at a time only; several runs may exist at the
/// same time.
class ProtocolRun {
 public:
  /// Begins with `start`, or continues a stopped run from its packing `reached` and its state `past`. No copy
  /// of the packing is kept besides that of the simulation. Throws InputError if the packing or the protocol
  /// is not valid.
  ProtocolRun(const Protocol& protocol, const Packing& start, int threads);
  ProtocolRun(const Protocol& protocol, const Packing& reached, int threads, const RunState& past);
  ProtocolRun(const ProtocolRun&) = delete;
  ProtocolRun& operator=(const ProtocolRun&) = delete;

  /// Creates the events, including the onlookers, and restores what they had saved. Must be called once,
  /// before go() and state().
  void begin(Onlookers onlookers = {});

  /// Runs to the verdict. `attention` as in compact().
  Outcome go(std::atomic<bool>* attention = nullptr);

  /// What a later run needs to continue from here, besides the packing.
  RunState state() const;

  Observation& now() { return now_; }
  const Simulation& simulation() const { return *simulation_; }
  const Protocol& protocol() const { return protocol_; }
  RestWatch& watch() { return watch_; }
  /// The pressures at which the packing came to rest or settled; after the verdicts jammed and settled, these
  /// include the present pressure.
  std::vector<RestingState> reached(Verdict verdict);
  std::int64_t lists_built() const;  ///< neighbour lists since the run began
  std::int64_t quenches() const;     ///< how often all motion was taken out
  std::int64_t evaluations() const;  ///< how often the minimizer computed all forces
  std::int64_t flips() const;        ///< how often the cell was flipped
  /// Bound on the further change of phi (engine/events/settle.h); infinite if none is known.
  double phi_bound() const;

  /// Returns the packing, ends the run and frees its memory.
  Packing take_packing();

 private:
  Outcome compact_on(std::atomic<bool>* attention);

  Protocol protocol_;
  std::vector<Barostat> baths_;  ///< one for each pressure
  Rhythm rhythm_;
  std::unique_ptr<Simulation> simulation_;
  Observation now_;
  RestWatch watch_;
  std::vector<RestingState> reached_;  ///< without the present pressure
  RunState past_;
  bool goes_on_ = false;  ///< the run continues a stopped run
  Events events_;
};

/// The result of jam(): a jammed packing, or the state at which the run ended.
struct Jam {
  Verdict verdict;
  std::string fault;                  ///< what made the run diverge; empty if nothing did
  Packing packing;                    ///< at the end
  Measures measures;                  ///< of that packing
  RestReport rest;                    ///< values of the criteria at the end
  std::vector<RestingState> reached;  ///< each pressure at which the packing came to rest or settled

  /// phi_J, which only a jammed packing has.
  std::optional<double> phi_J() const;
};

/// Runs a protocol from its start to the verdict. `threads` 0: as many as are worthwhile for this number of
/// spheres. The same start and protocol give the same bits for any number of threads. Throws InputError if
/// start or protocol is not valid; everything that goes wrong later is the verdict `diverged`.
Jam jam(const Packing& start, const Protocol& protocol = {}, int threads = 0);

}  // namespace furnas
