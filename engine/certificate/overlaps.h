#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/state/packing.h"

namespace furnas {

/// Two spheres that overlap; the second may be an image.
struct Overlap {
  std::uint32_t i{}, j{};
  std::array<std::int64_t, 3> cells{};  ///< branch = edges (s_i - s_j - cells), each s in [0, 1]
  Vec3<double> branch;                  ///< centre of j (its image) to centre of i [d_s]
};

/// All overlaps of a packing, each once and with all images, found from positions, radii and cell alone. This
/// search of the certificate shares no code with the engine's search.
std::vector<Overlap> find_overlaps(const Packing& packing);

}  // namespace furnas
