#pragma once

#include <vector>

#include "engine/base/sphere.h"
#include "engine/model.h"
#include "engine/state/packing.h"

namespace furnas {

// Trials are systems of a few spheres whose motion is known in closed form, and packings that are simulated
// for a short time. Tests use them, and `furnas bench` shows with them how the error grows with the time
// step.

/// The time step of the paper, 0.02 collision times of two small spheres [time].
inline constexpr double paper_step = 0.032415;

/// A sphere of density 1 in a trial; by default it has the radius of a small sphere.
struct Ball {
  Vec3<double> position{};  ///< [d_s]
  Vec3<double> velocity{};  ///< [d_s/time]
  Vec3<double> spin{};      ///< [1/time]
  double radius = 0.5;      ///< [d_s]
};

// These and the formulas below are written again and not taken from the engine, because tests compare the
// two.
inline double mass_of(double radius) { return sphere_volume(radius); }
inline double inertia_of(double radius) { return sphere_inertia(mass_of(radius), radius); }
inline double reduced_mass_of(double a, double b) { return 1 / (1 / mass_of(a) + 1 / mass_of(b)); }

inline Triangle cube(double length) { return {length, length, length, 0, 0, 0}; }

/// A start with these balls in the cell.
Packing packing_of(const Triangle& edges, const std::vector<Ball>& balls);

/// A model with this law and a fixed cell.
template <class Law>
Model model_of(const HookeConstants& constants, double time_step = paper_step) {
  Model model;
  model.law = Law{constants};
  model.time_step = time_step;
  model.barostat.freedom = CellFreedom::fixed;
  return model;
}

/// The packing after `steps` steps.
Packing after(const Model& model, const Packing& start, std::int64_t steps);

/// The inertia W of the cell for beta = 1: W = M L^2/12, L^3 = (volume of the spheres)/0.64 [rho d_s^5].
double inertia_of_cell(const Packing& packing);

/// Kinetic energy of translation and rotation [k_n d_s^2].
double kinetic_energy(const Packing& packing);

/// Energy of the contacts: sum of overlap^2/2 + k_t history^2/2 [k_n d_s^2].
double elastic_energy(const Packing& packing, double tangential_stiffness = 1);

/// Sum of m v [rho d_s^4/time].
Vec3<double> momentum(const Packing& packing);

/// The conserved quantity [k_n d_s^2] of a packing in a bath of pressure p_a, without damping, friction and
/// drag of the cell:
///
///   H' = K + U + p_a V + (W/2) sum(e_ab^2, a <= b),   K = sum(m v^2)/2,  U = sum(overlap^2)/2
double kept_enthalpy(const Packing& packing, const Barostat& bath);

}  // namespace furnas
