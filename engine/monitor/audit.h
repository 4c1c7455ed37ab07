#pragma once

#include <cstdint>
#include <string>

#include "engine/state/packing.h"

namespace furnas {

/// Compares the contacts of `sample` particles, drawn by `key`, with all others and all their images, which
/// costs `sample` times the number of particles. Answers a sentence about the first difference; empty if
/// there is none.
std::string audit_contacts(const Packing& packing, std::size_t sample, std::uint64_t key);

}  // namespace furnas
