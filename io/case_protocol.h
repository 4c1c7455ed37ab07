#pragma once

#include "engine/protocol/protocol.h"
#include "engine/start/mixture.h"
#include "io/case.h"

namespace furnas {

/// The mixture of a random start.
Mixture mixture_of(const Case& c);

/// How a case compresses its start until it jams.
Protocol protocol_of(const Case& c);

/// The packing that a case starts from: read from its file, or a random gas. Throws InputError.
Packing start_of(const Case& c);

/// z_min of a case: a particle with fewer live contacts does not belong to the backbone.
int backbone_threshold_of(const Case& c);

/// What a case simulates when it compresses `start`.
Model model_of(const Case& c, const Packing& start);

}  // namespace furnas
