#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "engine/state/packing.h"

namespace furnas {

/// Which two species are in contact.
enum class PairKind { large_large = 0, large_small = 1, small_small = 2 };

inline constexpr std::array pair_kinds{PairKind::large_large, PairKind::large_small, PairKind::small_small};

constexpr PairKind kind_of(Species a, Species b) {
  return static_cast<PairKind>(static_cast<int>(a) + static_cast<int>(b));
}

inline PairKind kind_of(const Packing& p, const Contact& c) {
  return kind_of(p.species[c.i], p.species[c.j]);
}

/// F . n, positive when it pushes [k_n d_s].
inline double normal_force(const Contact& c) { return dot(c.force, c.branch) / norm(c.branch); }

/// |F - F_n n| [k_n d_s].
inline double tangential_force(const Contact& c) {
  return norm(c.force - (dot(c.force, c.branch) / dot(c.branch, c.branch)) * c.branch);
}

/// Contacts that are analyzed together: their indices in Packing::contacts.
using Selection = std::vector<std::size_t>;

/// All contacts.
Selection all_contacts(const Packing& packing);

/// The live contacts between particles that are no rattlers, N_c.
Selection backbone_contacts(const Packing& packing, const std::vector<bool>& live,
                            const std::vector<bool>& rattler);

/// The contacts of a kind.
Selection of_kind(const Packing& packing, const Selection& contacts, PairKind kind);

}  // namespace furnas
