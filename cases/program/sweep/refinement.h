#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cases/program/sweep/points.h"

namespace furnas {

/// How well f_max is to be known, +-.
inline constexpr double wanted_f_max = 0.01;

/// Values of f_s to add to those that a curve has, so that its maximum is known better; none when it is known
/// well enough.
std::vector<double> fractions_to_add(const std::vector<double>& known, const CurveMaximum& maximum);

/// The samples that refine the curves of what has run so far: at each new point as many as at its neighbours.
std::vector<Sample> refining_samples(const std::vector<Sample>& samples, const std::vector<std::string>& keys,
                                     const std::filesystem::path& folder);

}  // namespace furnas
