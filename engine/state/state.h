#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "engine/base/refill.h"
#include "engine/base/vec3.h"
#include "engine/state/cell.h"
#include "engine/state/fraction.h"
#include "engine/state/ledger.h"
#include "engine/state/packing.h"
#include "engine/state/pair_list.h"
#include "engine/state/records.h"
#include "engine/state/stress.h"

namespace furnas {

/// The rows of all pairs of the list: one per pair, zero if the pair does not touch.
template <class Real, bool spins>
using Rows = std::vector<Row<Real, spins>>;

/// The state of pairs and particles that is kept from one step to the next.
template <class Real>
struct ContactState {
  std::vector<Spring<Real>> springs;   ///< one per pair; zero if it does not touch; empty without friction
  std::vector<std::uint8_t> touching;  ///< one per pair: 1 if it touched in the last step
  std::vector<ContactCount> contacts;  ///< one per particle: its contacts in the last step
  std::vector<std::uint8_t> loaded;    ///< one per particle: its LoadMark

  /// Resets the state to that of pairs that have never touched.
  void clear(std::size_t pairs, std::size_t particles, bool friction) {
    refill(springs, friction ? pairs : 0, {});
    refill(touching, pairs, std::uint8_t{0});
    if (contacts.size() != particles) contacts = std::vector<ContactCount>(particles);
    for (ContactCount& count : contacts) count.store(0, std::memory_order_relaxed);
    loaded.assign(particles, has_load);
  }

  /// Wakes the particles that sleep, because their velocities are about to change.
  void wake_all() { std::replace(loaded.begin(), loaded.end(), std::uint8_t{sleeps}, std::uint8_t{no_load}); }

  /// Records that row `k`, of particles i and j, touches.
  void touch(std::uint64_t k, std::uint32_t i, std::uint32_t j) {
    touching[k] = 1;
    contacts[i].fetch_add(1, std::memory_order_relaxed);
    contacts[j].fetch_add(1, std::memory_order_relaxed);
  }
};

/// Everything that a step changes. Particles are sorted by size class, then along a space-filling curve; `id`
/// gives their indices in the packing.
template <class Numerics>
struct State {
  using Real = typename Numerics::Real;

  std::int64_t step{};
  Cell cell;
  Stress stress;
  Ledger ledger;
  std::vector<Particle<Real, Numerics::spins>> particles;
  std::vector<Load<Real, Numerics::spins>> loads;
  PairList pairs;
  Rows<Real, Numerics::spins> rows;
  ContactState<Real> contact_state;

  std::vector<std::uint32_t> id;  ///< index in the packing of the n-th particle in memory
  std::vector<double> mass;       ///< [rho d_s^3]
  std::vector<Species> species;
  std::vector<Image> image;  ///< number of cells crossed until the list was built
};

}  // namespace furnas
