#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>

#include "engine/state/measures.h"

namespace furnas {

/// history.csv: a row of measures each few steps, under the column names of LAMMPS where it has one.
class History {
 public:
  /// Continues `path` after `step`: later rows are removed. A missing file is begun with its header.
  History(std::filesystem::path path, std::int64_t step);

  /// Appends a row and hands it to the system.
  void add(const Measures& measures);

 private:
  std::filesystem::path path_;
  std::ofstream file_;
};

/// Names of the columns, separated by commas.
std::string history_columns();

}  // namespace furnas
