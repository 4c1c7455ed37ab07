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
#include "engine/state/stress.h"

namespace furnas {

/// A law and the number type of the forces: what decides which fields a particle carries.
template <class LawType, class RealType>
struct Scene {
  using Law = LawType;
  using Real = RealType;
  static constexpr bool spins = Law::spins;
};

/// One record a particle: all that a contact reads of its partner, in one or two cache lines.
template <class Real, bool spins>
struct Particle;

template <class Real>
struct alignas(16) Particle<Real, false> {
  Fraction position;
  Vec3<Real> velocity;  ///< peculiar [d_s/time]
  Real radius;          ///< [d_s]
  Real inverse_mass;    ///< [1/(rho d_s^3)]
};

template <class Real>
struct alignas(16) Particle<Real, true> {
  Fraction position;
  Vec3<Real> velocity;   ///< peculiar [d_s/time]
  Real radius;           ///< [d_s]
  Real inverse_mass;     ///< [1/(rho d_s^3)]
  Vec3<Real> spin;       ///< angular velocity [1/time]
  Real inverse_inertia;  ///< 1/(0.4 m R^2) [1/(rho d_s^5)]
};

/// Sums over the contacts of one particle.
template <class Real, bool spins>
struct Load;

template <class Real>
struct Load<Real, false> {
  Vec3<Real> force;  ///< [k_n d_s]
};

template <class Real>
struct Load<Real, true> {
  Vec3<Real> force;   ///< [k_n d_s]
  Vec3<Real> torque;  ///< [k_n d_s^2]
};

/// What a candidate pair (i, j) answers in a step; all zero while the two do not touch.
template <class Real, bool spins>
struct Row;

template <class Real>
struct Row<Real, false> {
  Vec3<Real> force;  ///< on i [k_n d_s]
};

template <class Real>
struct Row<Real, true> {
  Vec3<Real> force;   ///< on i [k_n d_s]
  Vec3<Real> couple;  ///< normal x force; the torque on each is - (radius - shortening) couple [k_n d_s]
  Real shortening;    ///< [d_s]
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
  std::vector<Vec3<Real>> history;            ///< one a pair of the list; empty without friction [d_s]

  std::vector<std::uint32_t> id;  ///< index of each place in the packing
  std::vector<double> mass;       ///< [rho d_s^3]
  std::vector<Species> species;
  std::vector<Image> image;  ///< cells crossed until the list was built
};

}  // namespace furnas
