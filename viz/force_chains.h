#pragma once

#include <vtkSmartPointer.h>

#include "engine/state/packing.h"

class vtkActor;

namespace furnas {

/// The contacts as tubes from centre to centre. Thickness and brightness (graded(), viz/colouring.h) grow
/// with the normal force. The scale is logarithmic, because forces grow with the square of the sphere size.
/// It extends from a hundredth of `strongest`, below which nothing is drawn, to `strongest` and above [k_n
/// d_s]. Of a contact across a face of the cell two halves are drawn, each at its own particle.
vtkSmartPointer<vtkActor> force_chains(const Packing& packing, double strongest);

/// The normal force that only one contact in a hundred exceeds [k_n d_s]; 0 without contacts.
double strong_force(const Packing& packing);

}  // namespace furnas
