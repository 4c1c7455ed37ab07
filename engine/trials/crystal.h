#pragma once

#include "engine/trials/balls.h"

namespace furnas {

/// Crystals of small spheres with the distance r of nearest neighbours, r < 1 so that they overlap.

/// Simple cubic, `cells` spheres along each edge.
Packing simple_cubic(double r, int cells);

/// Face-centred cubic in its cubic cell of 4 spheres, `cells` of them along each edge.
Packing face_centred(double r, int cells);

/// Face-centred cubic in its smallest cell, one sphere.
Packing face_centred_primitive(double r);

/// Pressure of the contacts [k_n/d_s].
double contact_pressure(const Packing& packing);

/// Forces taken from the positions, without a step.
Packing with_forces(const Model& model, const Packing& packing);

/// Change of the stress per strain after a small steady deformation of a crystal whose contacts never slide
/// and do not damp; its particles turn with the mean rotation, as symmetry asks. Of `model` count law and
/// time step [k_n/d_s].
Eigen::Matrix3d stress_per_strain(Model model, const Packing& crystal, const Triangle& strain);

/// C44 of the face-centred crystal of distance r with stuck contacts, overlap -> 0: sqrt 2 (k_n + k_t)/(2 r).
double shear_modulus_of_face_centred(double r, double tangential_stiffness = 1);

}  // namespace furnas
