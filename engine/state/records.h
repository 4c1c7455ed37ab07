#pragma once

#include <atomic>
#include <cstdint>

#include "engine/base/vec3.h"
#include "engine/state/fraction.h"

namespace furnas {

/// A law and the number type of the forces: what decides which fields a particle carries.
template <class LawType, class RealType>
struct Numerics {
  using Law = LawType;
  using Real = RealType;
  static constexpr bool spins = Law::spins;
};

/// One record a particle: all that a contact reads of its partner. With friction and `float` it is one cache
/// line. A vector and the number behind it are read as one group of four.
template <class Real, bool spins>
struct Particle;

template <class Real>
struct alignas(16) Particle<Real, false> {
  Fraction position;
  Real radius;          ///< [d_s]
  Vec3<Real> velocity;  ///< peculiar [d_s/time]
  Real inverse_mass;    ///< [1/(rho d_s^3)]
};

template <class Real>
struct alignas(32) Particle<Real, true> {
  Fraction position;
  Real radius;           ///< [d_s]
  Vec3<Real> velocity;   ///< peculiar [d_s/time]
  Real inverse_mass;     ///< [1/(rho d_s^3)]
  Vec3<Real> spin;       ///< angular velocity [1/time]
  Real inverse_inertia;  ///< 1/(0.4 m R^2) [1/(rho d_s^5)]
};

static_assert(sizeof(Particle<float, true>) == 64, "one cache line");

/// Sums over the contacts of one particle.
template <class Real, bool spins>
struct Load;

template <class Real>
struct Load<Real, false> {
  Vec3<Real> force;  ///< [k_n d_s]
  Real unused;
};

template <class Real>
struct Load<Real, true> {
  Vec3<Real> force;  ///< [k_n d_s]
  Real unused;
  Vec3<Real> torque;  ///< [k_n d_s^2]
  Real unused_too;
};

/// What a candidate pair (i, j) answers in a step; all zero while the two do not touch.
template <class Real, bool spins>
struct Row;

template <class Real>
struct Row<Real, false> {
  Vec3<Real> force;  ///< on i [k_n d_s]
  Real unused;
};

template <class Real>
struct Row<Real, true> {
  Vec3<Real> force;   ///< on i [k_n d_s]
  Real minus_arm_i;   ///< lever arm of i, with a minus [d_s]
  Vec3<Real> couple;  ///< normal x force; times minus the arm of a particle the torque on it [k_n d_s]
  Real minus_arm_j;   ///< lever arm of j, with a minus [d_s]
};

/// How much of the work of a pass over particles may be left out for a particle.
enum LoadMark : std::uint8_t {
  no_load,   ///< it touches nothing and its load is zero
  has_load,  ///< it may touch something
  sleeps     ///< no load and no velocity: no pass changes a bit of it until it is touched
};

/// How many contacts a particle has. Several threads may count at once.
using ContactCount = std::atomic<std::uint32_t>;

/// Tangential displacement of a contact, in a group of four.
template <class Real>
struct Spring {
  Vec3<Real> history;  ///< xi of i against j [d_s]
  Real unused;
};

}  // namespace furnas
