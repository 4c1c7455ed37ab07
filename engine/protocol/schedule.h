#pragma once

#include <vector>

#include "engine/compaction.h"
#include "engine/events/at_rest.h"
#include "engine/protocol/protocol.h"

namespace furnas {

/// Events that the caller adds to a protocol, in three groups by their place in the order of events.
struct Onlookers {
  Events before_verdict;  ///< these see the packing directly after the step: history, frames
  Events after_verdict;   ///< these see the packing after all events of the protocol: progress, checkpoints
  Events limits;          ///< these may end the run: limits of the wall time, signals
};

/// All events of a run, in the order in which events of one step happen. `later` are the baths that follow
/// the one in which the run begins; the pressures at which the packing comes to rest or settles are added to
/// `reached`.
Events schedule(const Protocol& protocol, const Rhythm& rhythm, std::vector<Barostat> later, RestWatch& watch,
                std::vector<RestingState>& reached, Onlookers onlookers);

}  // namespace furnas
