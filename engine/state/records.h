#pragma once

#include <atomic>
#include <cstdint>

#include "engine/base/vec3.h"
#include "engine/state/fraction.h"

namespace furnas {

/// A law and the number type of the forces. They determine the fields of a particle's record.
template <class LawType, class RealType>
struct Numerics {
  using Law = LawType;
  using Real = RealType;
  static constexpr bool spins = Law::spins;
};

/// The record of a particle: everything that a contact reads of its particles. With friction and `float` a
/// record is one cache line. A vector and the number after it are read as one group of four.
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
struct alignas(sizeof(Real) == 4 ? 64 : 32) Particle<Real, true> {
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

/// The row of a pair (i, j): its force in a step; all zero if the two do not touch.
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
  Vec3<Real> couple;  ///< normal x force; times minus a lever arm: torque on i or j [k_n d_s]
  Real minus_arm_j;   ///< lever arm of j, with a minus [d_s]
};

/// Which parts of a pass over particles can be skipped for a particle.
enum LoadMark : std::uint8_t {
  no_load,   ///< the particle touches nothing, and its load is zero
  has_load,  ///< the particle may touch something
  sleeps     ///< no load and no velocity: no pass changes the particle until it is touched
};

/// Number of contacts of a particle. Several threads may count at the same time.
using ContactCount = std::atomic<std::uint32_t>;

/// Tangential displacement of a contact, in a group of four.
template <class Real>
struct Spring {
  Vec3<Real> history;  ///< xi of i against j [d_s]
  Real unused;
};

}  // namespace furnas
