#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cases/program/sweep/points.h"

namespace furnas {

/// Wanted accuracy of f_max, +-.
inline constexpr double wanted_f_max = 0.01;

/// Values of f_s to add to a curve, to determine its maximum more accurately; none when it is accurate
/// enough.
std::vector<double> fractions_to_add(const std::vector<double>& known, const CurveMaximum& maximum);

/// The samples that refine the present curves: at each new point as many as at the highest point.
std::vector<Sample> refining_samples(const std::vector<Sample>& samples, const std::vector<std::string>& keys,
                                     const std::filesystem::path& folder);

}  // namespace furnas
