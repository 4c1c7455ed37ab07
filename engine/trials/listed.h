#pragma once

#include "engine/search/find_pairs.h"
#include "engine/search/size_classes.h"
#include "engine/state/packing.h"

namespace furnas {

/// The packing with its particles in the order of memory.
inline Packing in_memory_order(const Packing& p) {
  Packing sorted = p;
  const std::vector<std::uint32_t> order = memory_order(p);
  for (std::size_t n = 0; n < order.size(); ++n) {
    sorted.species[n] = p.species[order[n]];
    sorted.radius[n] = p.radius[order[n]];
    sorted.mass[n] = p.mass[order[n]];
    sorted.fraction[n] = p.fraction[order[n]];
    sorted.velocity[n] = p.velocity[order[n]];
    sorted.spin[n] = p.spin[order[n]];
  }
  return sorted;
}

/// The neighbour list of a packing that is in the order of memory.
inline PairList listed(const Packing& p, const Skin& skin) {
  PairList list;
  list.classes = size_classes(p.radius);
  list.skin = skin;
  list.reference = p.fraction;
  find_pairs(bin_classes(list.classes, skin, p.cell.edges, p.fraction), p.cell.edges, p.radius, list);
  return list;
}

}  // namespace furnas
