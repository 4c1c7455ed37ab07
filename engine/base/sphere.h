#pragma once

#include <numbers>

namespace furnas {

/// Volume of a sphere of this radius.
constexpr double sphere_volume(double radius) { return 4 * std::numbers::pi / 3 * radius * radius * radius; }

/// Mass of a sphere [rho d_s^3] of this radius [d_s] and density [rho].
constexpr double sphere_mass(double radius, double density = 1) { return density * sphere_volume(radius); }

/// m_i m_j/(m_i + m_j); exactly m/2 for two equal masses.
constexpr double reduced_mass(double mass_i, double mass_j) { return mass_j / (1 + mass_j / mass_i); }

/// Moment of inertia of a solid sphere about its centre.
constexpr double sphere_inertia(double mass, double radius) { return 0.4 * mass * radius * radius; }

}  // namespace furnas
