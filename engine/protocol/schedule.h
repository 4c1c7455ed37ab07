#pragma once

#include <vector>

#include "engine/compaction.h"
#include "engine/events/at_rest.h"
#include "engine/protocol/protocol.h"

namespace furnas {

/// Events of whoever runs a protocol, by their turn among those of the protocol.
struct Onlookers {
  Events before_verdict;  ///< they see the packing as the step left it: a history, frames
  Events after_verdict;   ///< they see what the verdict left: progress, checkpoints
  Events limits;          ///< they may end the run besides its steps: a wall time, a signal
};

/// All that can happen in a run, in the order in which events of one step happen. `later` are the baths that
/// follow the one in which the run begins; the pressures at which the packing comes to rest are added to
/// `reached`.
Events schedule(const Protocol& protocol, const Rhythm& rhythm, std::vector<Barostat> later, RestWatch& watch,
                std::vector<RestingState>& reached, Onlookers onlookers);

}  // namespace furnas
