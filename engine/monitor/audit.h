#pragma once

#include <cstdint>
#include <string>

#include "engine/state/packing.h"

namespace furnas {

/// Checks the contacts of `sample` particles against a search over all particles and all their images. `key`
/// selects the sample. The cost is `sample` times the number of particles. Returns a sentence about the first
/// difference; empty if there is none.
std::string audit_contacts(const Packing& packing, std::size_t sample, std::uint64_t key);

}  // namespace furnas
