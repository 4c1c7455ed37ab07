#pragma once

#include <vector>

#include "engine/base/sphere.h"
#include "engine/model.h"
#include "engine/simulation.h"
#include "engine/state/packing.h"

namespace furnas {

/// The time step of the study, 0.02 collision times of two small spheres [time].
inline constexpr double paper_step = 0.032415;

/// A sphere of density 1 as a test puts it down; its radius is that of a small one unless said otherwise.
struct Ball {
  Vec3<double> position{};  ///< [d_s]
  Vec3<double> velocity{};  ///< [d_s/time]
  Vec3<double> spin{};      ///< [1/time]
  double radius = 0.5;      ///< [d_s]
};

inline double mass_of(double radius) { return sphere_volume(radius); }
inline double inertia_of(double radius) { return sphere_inertia(mass_of(radius), radius); }
inline double reduced_mass_of(double a, double b) { return 1 / (1 / mass_of(a) + 1 / mass_of(b)); }

inline Triangle cube(double length) { return {length, length, length, 0, 0, 0}; }

/// A start with the balls at their places in the cell.
Packing packing_of(const Triangle& edges, const std::vector<Ball>& balls);

/// A law in a cell that does not move.
template <class Law>
Model model_of(const HookeConstants& constants, double time_step = paper_step) {
  Model model;
  model.law = Law{constants};
  model.time_step = time_step;
  model.barostat.freedom = CellFreedom::fixed;
  return model;
}

/// The state after some steps.
Packing after(const Model& model, const Packing& start, std::int64_t steps);

/// The inertia of the packing itself, W = M L^2/12, L^3 = (volume of the spheres)/0.64 [rho d_s^5].
double inertia_of_cell(const Packing& packing);

/// Translation and rotation [k_n d_s^2].
double kinetic_energy(const Packing& packing);

/// Of the contacts: overlap^2/2 + k_t history^2/2 [k_n d_s^2].
double elastic_energy(const Packing& packing, double tangential_stiffness = 1);

Vec3<double> momentum(const Packing& packing);

/// About the origin, of the unwrapped positions, with spin.
Vec3<double> angular_momentum(const Packing& packing);

/// Largest |a - b| of two lists of vectors.
double largest_difference(const std::vector<Vec3<double>>& a, const std::vector<Vec3<double>>& b);

/// Sum of |force| over the contacts.
double sum_of_forces(const Packing& packing);

/// The same lattice of spheres described by other edges: b gains `xy` times a, c gains `xz` times a and `yz`
/// times b. Contacts keep what they are about; the count of crossed cells starts anew.
Packing reskewed(const Packing& packing, int xy, int xz, int yz);

/// A handful of overlapping, spinning spheres of several sizes about the origin.
std::vector<Ball> cluster();

/// Balls about the origin, put in the middle of a cell so large that they are alone.
Packing alone(std::vector<Ball> balls, double side = 128);

/// About 200 spheres of size ratio 3 with friction 0.3, compressed to a packing at pressure 1e-4; its
/// contacts carry histories. Made once, with the default law.
const Packing& jammed();

/// The jammed packing squeezed by 5 % along each edge and its particles kicked: far above jamming, so that it
/// stays a packing under any law and friction.
Packing squeezed(double speed);

/// The law and step that `jammed` was made with, in a cell that does not move.
Model jammed_model();

}  // namespace furnas
