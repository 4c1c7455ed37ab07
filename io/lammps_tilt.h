#pragma once

#include <utility>

#include "engine/state/shorter_edges.h"

namespace furnas {

/// Calls `write` with the packing. LAMMPS refuses a cell tilted by more than half an edge; in that case
/// `write` gets a copy with shorter edges of the same lattice.
template <class Write>
void write_for_lammps(const Packing& packing, Write&& write) {
  constexpr double farthest_tilt = 0.5;
  if (!is_tilted(packing.cell.edges, farthest_tilt)) return std::forward<Write>(write)(packing);
  Packing shorter = packing;
  shorten_edges(shorter, farthest_tilt);
  std::forward<Write>(write)(shorter);
}

}  // namespace furnas
