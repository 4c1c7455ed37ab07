#pragma once

#include "engine/trials/balls.h"

namespace furnas {

// The crystals below consist of small spheres. r is the distance of nearest neighbours, with r < 1, so that
// the spheres overlap.

/// Simple cubic crystal with `cells` spheres along each edge.
Packing simple_cubic(double r, int cells);

/// Face-centred cubic crystal of cubic cells of 4 spheres, with `cells` such cells along each edge.
Packing face_centred(double r, int cells);

/// Face-centred cubic crystal in its primitive cell of one sphere.
Packing face_centred_primitive(double r);

/// Pressure of the contacts [k_n/d_s].
double contact_pressure(const Packing& packing);

/// The packing with forces computed from the positions, without a step.
Packing with_forces(const Model& model, const Packing& packing);

/// Change of the stress per strain after a small steady deformation of a crystal [k_n/d_s]. The contacts do
/// not slide and have no damping; by symmetry the particles rotate with the mean rotation. Only the law and
/// the time step of `model` are used.
Eigen::Matrix3d stress_per_strain(Model model, const Packing& crystal, const Triangle& strain);

/// C44 = sqrt 2 (k_n + k_t)/(2 r): face-centred crystal of distance r with sticking contacts, in the limit
/// overlap -> 0.
double shear_modulus_of_face_centred(double r, double tangential_stiffness = 1);

}  // namespace furnas
