#pragma once

#include <array>
#include <cstdint>

#include "engine/analysis/contacts.h"

namespace furnas {

/// How many contacts particles have.
struct Coordination {
  std::int64_t large{}, small{};           ///< particles that were counted
  std::array<std::int64_t, 3> contacts{};  ///< of each kind, by PairKind

  std::int64_t particles() const { return large + small; }
  std::int64_t all_contacts() const { return contacts[0] + contacts[1] + contacts[2]; }

  /// Z = 2 contacts/particles; 0 without particles.
  double mean() const;

  /// Mean number of contacts of a particle of one species with particles of another (or its own); 0 without
  /// particles. With N_ls contacts between large and small particles, a large particle has N_ls/N_l contacts
  /// with small ones, and a small particle N_ls/N_s with large ones.
  double of(Species species, Species with) const;

  /// Mean number of contacts of a particle of one species.
  double of(Species species) const { return of(species, Species::large) + of(species, Species::small); }
};

/// Counts all particles and contacts.
Coordination coordination(const Packing& packing);

/// Counts only the particles of the backbone, and the contacts of backbone_contacts().
Coordination coordination(const Packing& packing, const std::vector<bool>& rattler,
                          const Selection& contacts);

}  // namespace furnas
