#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cases/program/sweep/sample_table.h"

namespace furnas {

/// A key of the case and the values it takes among some samples.
struct VaryingKey {
  std::string key;
  std::vector<std::string> values;  ///< each once, numbers ascending
};

/// The samples of several sweeps in one table, told apart by all that bears on phi_J.
struct Gathered {
  /// Its keys are size_ratio, small_fraction, friction, those of the sweeps, and those in which the cases of
  /// the sweeps differ. Numbers have one spelling; an empty value is not known.
  SampleTable table;
  std::vector<std::filesystem::path> runs;    ///< the folder of each row's run, whether it is there or not
  std::vector<std::filesystem::path> sweeps;  ///< the folder of each row's sweep
  std::vector<std::string> remarks;           ///< what the reader ought to know, in sentences

  /// Keys with several values among the samples.
  std::vector<VaryingKey> varying() const;
};

/// Reads the tables of the folders of sweeps. The same run in two folders counts once. Throws InputError.
Gathered gather(const std::vector<std::filesystem::path>& folders);

/// The command that makes equal spheres by the rules of a sweep, from which the model follows.
std::string command_for_equal_spheres(const std::filesystem::path& sweep, double friction);

}  // namespace furnas
