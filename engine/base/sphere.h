#pragma once

#include <numbers>

namespace furnas {

/// Volume of a sphere of this radius.
constexpr double sphere_volume(double radius) { return 4 * std::numbers::pi / 3 * radius * radius * radius; }

/// Moment of inertia of a solid sphere about its centre.
constexpr double sphere_inertia(double mass, double radius) { return 0.4 * mass * radius * radius; }

}  // namespace furnas
