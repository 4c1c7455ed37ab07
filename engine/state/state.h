#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/base/vec3.h"
#include "engine/state/cell.h"
#include "engine/state/fraction.h"
#include "engine/state/ledger.h"
#include "engine/state/packing.h"
#include "engine/state/pair_list.h"
#include "engine/state/records.h"
#include "engine/state/stress.h"

namespace furnas {

/// What the pairs of the list remember from one step to the next.
template <class Real>
struct Memory {
  std::vector<Spring<Real>> springs;   ///< one a pair; zero while it does not touch; empty without friction
  std::vector<std::uint8_t> touching;  ///< one a pair: 1 if it touched in the last step

  /// A memory of pairs that have never touched.
  void clear(std::size_t pairs, bool friction) {
    springs.assign(friction ? pairs : 0, {});
    touching.assign(pairs, 0);
  }
};

/// Everything that a step changes. Particles are in order of size class, then along a space-filling
/// curve; `id` tells who they are.
template <class Scene>
struct State {
  using Real = typename Scene::Real;

  std::int64_t step{};
  Cell cell;
  Stress stress;
  Ledger ledger;
  std::vector<Particle<Real, Scene::spins>> particles;
  std::vector<Load<Real, Scene::spins>> loads;
  PairList pairs;
  std::vector<Row<Real, Scene::spins>> rows;  ///< one a pair of the list
  Memory<Real> memory;

  std::vector<std::uint32_t> id;  ///< index of each place in the packing
  std::vector<double> mass;       ///< [rho d_s^3]
  std::vector<Species> species;
  std::vector<Image> image;  ///< cells crossed until the list was built
};

}  // namespace furnas
