#pragma once

#include <string>
#include <vector>

#include "cases/program/sweep/plan.h"

namespace furnas {

/// Approximate thickness of the dense cell of a case, in largest diameters; infinite where the start is a
/// packing in a file.
double thickness_in_diameters(const Case& c);

/// A line for the user about the points of a sweep whose cells are too thin to represent a large packing,
/// with a sufficient number of spheres; empty if there are no such points.
std::string remark_on_thin_cells(const std::vector<Sample>& samples);

}  // namespace furnas
