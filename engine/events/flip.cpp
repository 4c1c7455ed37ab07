#include "engine/events/flip.h"

#include "engine/state/shorter_edges.h"

namespace furnas {
namespace {

constexpr double farthest_tilt = 0.55;  // above 1/2, so that a cell does not flip back and forth

}  // namespace

bool flip_cell(Packing& packing) { return shorten_edges(packing, farthest_tilt); }

bool Flip::due(Observation& now) { return is_tilted(now.simulation().cell().edges, farthest_tilt); }

std::optional<Verdict> Flip::fire(Observation& now) {
  Packing packing = now.take_packing();
  if (flip_cell(packing)) {
    now.replace(packing);
    ++count_;
  }
  return {};
}

}  // namespace furnas
