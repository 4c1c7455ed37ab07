#pragma once

#include <string>
#include <vector>

#include "cases/program/sweep/plan.h"

namespace furnas {

/// About how thick a cell of the case is once it is dense, in largest diameters; infinite where
/// the start is a packing in a file.
double dense_thickness(const Case& c);

/// A line for a person about the points of a sweep whose cells are too thin to stand for a large packing,
/// with the number of spheres that would do; empty if there are none.
std::string remark_on_thin_cells(const std::vector<Sample>& samples);

}  // namespace furnas
