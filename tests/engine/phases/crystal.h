#pragma once

#include "tests/engine/support/setups.h"

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

}  // namespace furnas
