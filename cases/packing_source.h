#pragma once

#include <string>

#include "engine/state/packing.h"

namespace furnas {

/// The packing of the folder of a run (its newest checkpoint, with all contacts) or of a file of any format.
Packing packing_from(const std::string& folder_or_file);

}  // namespace furnas
