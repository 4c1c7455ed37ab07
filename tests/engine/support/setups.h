#pragma once

#include <vector>

#include "engine/simulation.h"
#include "engine/trials/balls.h"

namespace furnas {

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
