#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "cases/program/sweep/plan.h"

namespace furnas {

/// The name of the table of samples in the folder of a sweep.
inline constexpr const char* sample_table_name = "sweep.csv";

/// The result of a sample.
struct SampleRow {
  static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

  std::vector<std::string> values;  ///< of the keys of its table
  double size_ratio = 1;            ///< alpha
  double small_fraction{};          ///< f_s
  double friction{};                ///< mu
  std::int64_t seed{};
  std::int64_t large{}, small{};  ///< particles of each species; 0 when it has no result
  std::string verdict;            ///< that of result.json, "failed" or "unfinished"
  std::string reason;
  double phi_J = unknown;       ///< NaN unless jammed
  double phi = unknown;         ///< at the end; NaN without a result, as the three below
  double Z = unknown;           ///< 2 contacts/particles, rattlers included
  double Z_backbone = unknown;  ///< the same of the backbone
  double backbone = unknown;    ///< particles in the backbone
  std::array<std::int64_t, 3> large_rattlers{}, small_rattlers{};  ///< with z_min 2, 3, 4
  double phi_bound = unknown;  ///< of a settled sample, bound on the further change of phi; else NaN
  std::int64_t steps{};
  double wall_seconds{};
  double cpu_seconds = unknown;  ///< of all threads; NaN in a read table
  std::int64_t evaluations{};    ///< of the minimizer; 0 in a table that was read
  std::string state_hash;
  /// Thickness of the cell, in diameters of the largest sphere. This and the following values are NaN or
  /// empty without a result, and in tables of older versions.
  double thickness = unknown;
  double pressure = unknown;  ///< of the bath at the end, p_a [k_n/d_s]
  std::string preset;         ///< of the case; empty if not known

  bool jammed() const { return verdict == "jammed"; }
  bool settled() const { return verdict == "settled"; }
  /// phi_J, or phi of a settled sample; NaN for all others.
  double density() const { return settled() ? phi : phi_J; }
};

/// Numbers of samples with each verdict.
struct VerdictCounts {
  std::size_t samples{};  ///< all of them
  std::size_t jammed{}, settled{}, budget{}, diverged{}, failed{}, unfinished{};

  void count(const SampleRow& row);
};

/// The samples of a sweep, a row each.
struct SampleTable {
  std::vector<std::string> keys;  ///< "mixture.size_ratio", ...
  std::vector<SampleRow> rows;
};

/// Reads the results of the samples from their folders.
SampleTable table_of(const std::vector<Sample>& samples, const std::vector<std::string>& keys);

/// The table as text (the columns after the keys: cases/program/sweep/sample_columns.h); an empty cell is not
/// known.
std::string csv(const SampleTable& table);

/// Reads the table of a sweep's folder. Throws InputError.
SampleTable read_sample_table(const std::filesystem::path& folder);

}  // namespace furnas
