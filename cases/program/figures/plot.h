#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "viz/chart.h"

namespace furnas {

/// A figure that a user orders: a column against a key, with a curve for each value of other keys.
struct PlotOrder {
  std::vector<std::filesystem::path> sweeps;  ///< their folders
  std::string x{};                            ///< a key of the case, or its name alone if one key has it
  std::string y = "phi_J";        ///< a mean of points.csv, a column of sweep.csv or a field of result.json
  std::vector<std::string> by{};  ///< keys of the curves; empty: all others that vary
  std::vector<std::string> where{};  ///< "key=value": only these samples
};

/// The figure, with its name and axes.
struct Plot {
  std::string name;  ///< of its files, without extension: "phi_J_against_friction_by_pressure"
  std::string x, y;  ///< full names of the quantities on the axes
  Chart chart;       ///< means of jammed and settled samples with 95 % intervals, and the model
  std::vector<std::string> remarks;  ///< remarks for the reader, in sentences
};

/// Reads the sweeps and draws. Throws InputError, also when samples of one point of one curve differ in
/// another key that bears on phi_J.
Plot plot_of(const PlotOrder& order);

}  // namespace furnas
