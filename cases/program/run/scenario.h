#pragma once

#include "engine/events/at_rest.h"
#include "engine/model.h"
#include "engine/start/mixture.h"
#include "io/case.h"

namespace furnas {

/// The mixture of a random start.
Mixture mixture_of(const Case& c);

/// The packing that the case starts from: read from its file, or a random gas.
Packing start_of(const Case& c);

/// What is simulated: the law and its constants, the bath, the time step. The cell's inertia follows from
/// the spheres of `packing`.
Model model_of(const Case& c, const Packing& packing);

/// When it counts as jammed.
RestCriteria rest_criteria_of(const Case& c);

/// What is to be said of a cell so many of its largest diameters thick: below 3 spheres share their
/// neighbours with their own images, and it does not stand for a large packing.
const char* remark_on_thickness(double diameters);

/// Live contacts below which a particle is no part of the backbone: 4 without friction (d + 1), 2 with,
/// because of bridges.
int backbone_threshold_of(const Case& c);

}  // namespace furnas
