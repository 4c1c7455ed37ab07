#pragma once

#include <filesystem>
#include <functional>
#include <limits>
#include <optional>
#include <string>

#include "cases/program/sweep/sample_table.h"

namespace furnas {

/// A number that each sample has: what is plotted against a key.
struct Quantity {
  std::string name;   ///< "phi_J", "energy.kinetic"
  std::string title;  ///< for the axis of a chart
  /// Its value for a sample, whose run is in the folder; empty if the sample has none. Throws InputError.
  std::function<std::optional<double>(const SampleRow& row, const std::filesystem::path& run)> of;
  double least = -std::numeric_limits<double>::infinity();  ///< least possible value
  double most = std::numeric_limits<double>::infinity();    ///< largest possible value
};

/// The quantity of this name: a mean of points.csv, or else a column of sweep.csv, or else a number of
/// result.json, with dots between nested names ("stress.xx"). Throws InputError if its values are words.
Quantity quantity_named(const std::string& name);

/// The key for a symbol of docs/reference/notation.md such as "f_s"; empty if there is none.
std::string key_of_symbol(const std::string& symbol);

/// A key of the case on the axis of a chart: "μ", "p_a / (k_n/d_s)", "cell damping".
std::string title_of_key(const std::string& key);

/// The same in a legend, without unit.
std::string symbol_of_key(const std::string& key);

}  // namespace furnas
