#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cases/program/sweep/sample_table.h"

namespace furnas {

/// The key that sets the size of a sample.
inline constexpr const char* number_of_large = "mixture.large";

/// A key of the case and the values it takes among some samples.
struct VaryingKey {
  std::string key;
  std::vector<std::string> values;  ///< without repetition, numbers in ascending order
};

/// The samples of several sweeps in one table, whose keys include all that bear on phi_J and differ.
struct Gathered {
  /// Its keys are those of the paper, those of the sweeps, and those in which the cases of
  /// the sweeps differ. Equal numbers have equal spellings; an empty value is not known.
  SampleTable table;
  std::vector<std::filesystem::path> runs;    ///< the folder of each row's run, which need not exist
  std::vector<std::filesystem::path> sweeps;  ///< the folder of each row's sweep
  std::vector<std::string> remarks;           ///< remarks for the reader, in sentences

  /// Keys with several values among the samples.
  std::vector<VaryingKey> varying() const;
};

/// Reads the tables of the folders of sweeps. The same run in two folders counts once. Throws InputError.
Gathered gather(const std::vector<std::filesystem::path>& folders);

/// The command that makes samples of equal spheres with the settings of a sweep; the model needs them.
std::string command_for_equal_spheres(const std::filesystem::path& sweep, double friction);

}  // namespace furnas
