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

/// What a stopped run hands to the one that goes on with it, besides its packing and its protocol.
struct RunState {
  std::vector<RestingState> reached;          ///< pressures at which it had come to rest
  RestWatch::Saved watch;                     ///< the window of the verdict
  std::map<std::string, std::string> events;  ///< what each event has saved, by the name of the event
  std::int64_t replaced{};                    ///< times an event had changed the packing
  std::int64_t lists_built{};                 ///< neighbour lists
};

/// How a run ended.
struct Outcome {
  Verdict verdict;
  std::string fault;     ///< what made it diverge, in a sentence; empty if nothing did
  bool is_sound = true;  ///< the packing has no fault, and a run may go on from it
};

/// A packing on its way through a protocol. The run reads and writes no files; a program that wants files
/// adds events that write them. Not safe for use by several threads at once; several runs may be made side by
/// side.
class ProtocolRun {
 public:
  /// Begins with the start, or goes on where `past` had come. The start is not kept: once this returns there
  /// is no second copy of it. Throws InputError for a start that is no packing.
  ProtocolRun(const Protocol& protocol, const Packing& start, int threads);
  ProtocolRun(const Protocol& protocol, const Packing& reached, int threads, const RunState& past);
  ProtocolRun(const ProtocolRun&) = delete;
  ProtocolRun& operator=(const ProtocolRun&) = delete;

  /// Puts the events together, with the onlookers among them, and hands back what they had saved. Once,
  /// before go() and state().
  void begin(Onlookers onlookers = {});

  /// Runs to the verdict. `attention` as in compact().
  Outcome go(std::atomic<bool>* attention = nullptr);

  /// What a later run needs to go on from here, besides the packing.
  RunState state() const;

  Observation& now() { return now_; }
  const Simulation& simulation() const { return *simulation_; }
  const Protocol& protocol() const { return protocol_; }
  RestWatch& watch() { return watch_; }
  /// The pressures at which the packing came to rest; after a verdict of jammed, the one it stands at, too.
  std::vector<RestingState> reached(Verdict verdict);
  std::int64_t lists_built() const;  ///< neighbour lists since the run began
  std::int64_t quenches() const;     ///< times all motion was taken out
  std::int64_t evaluations() const;  ///< times the minimizer computed all forces
  std::int64_t flips() const;        ///< times the cell was flipped
  /// Bound on what phi may still change (engine/events/settle.h); infinite where none is known.
  double phi_bound() const;

  /// The packing; the run is over, and its memory free.
  Packing take_packing();

 private:
  Outcome compact_on(std::atomic<bool>* attention);

  Protocol protocol_;
  std::vector<Barostat> baths_;  ///< one for each pressure
  Rhythm rhythm_;
  std::unique_ptr<Simulation> simulation_;
  Observation now_;
  RestWatch watch_;
  std::vector<RestingState> reached_;  ///< before the pressure it stands at
  RunState past_;
  bool goes_on_ = false;  ///< from where another run had come
  Events events_;
};

/// A jammed packing, or how far it came.
struct Jam {
  Verdict verdict;
  std::string fault;                  ///< what made the run diverge; empty if nothing did
  Packing packing;                    ///< at the end
  Measures measures;                  ///< of that packing
  RestReport rest;                    ///< how the criteria stood at the end
  std::vector<RestingState> reached;  ///< each pressure at which the packing came to rest

  /// phi_J, which only a jammed packing has.
  std::optional<double> phi_J() const;
};

/// Runs a protocol from its start to the verdict. `threads` 0: as many as pay for so many spheres. The same
/// start and protocol give the same bits for any number of threads.
Jam jam(const Packing& start, const Protocol& protocol = {}, int threads = 0);

}  // namespace furnas
