#pragma once

#include <cstdint>
#include <vector>

#include "engine/state/packing.h"
#include "engine/state/pair_list.h"

namespace furnas {

/// Groups radii into classes, largest first; within a class the largest radius is at most 1.5 times the
/// smallest. The ranges refer to particles sorted by `memory_order`. Throws InputError if a class comes
/// before a larger one.
std::vector<SizeClass> size_classes(const std::vector<double>& radii_in_order);

/// The order of particles in memory: by size class, largest first, then along a Morton curve through
/// the cell, then by index. A pure function of the packing.
std::vector<std::uint32_t> memory_order(const Packing& packing);

}  // namespace furnas
