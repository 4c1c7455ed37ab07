#pragma once

#include "engine/laws/any_law.h"
#include "engine/state/packing.h"

namespace furnas {

/// The input of a law for a contact of a packing without any motion.
Touch<double> touch_of(const Packing& packing, const Contact& contact);

/// Kinetic energy of a sphere: of its peculiar motion and of its spin [k_n d_s^2].
double kinetic_energy(double mass, double radius, const Vec3<double>& velocity, const Vec3<double>& spin);

/// Kinetic energy of particle k: of its peculiar motion and of its spin [k_n d_s^2].
double kinetic_energy(const Packing& packing, std::size_t k);

/// Energy of all particles and of the springs of this law in all contacts.
Energy energy(const Packing& packing, const AnyLaw& law);

}  // namespace furnas
