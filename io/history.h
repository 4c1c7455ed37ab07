#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "engine/state/measures.h"
#include "io/append_file.h"
#include "io/output_field.h"

namespace furnas {

/// history.csv: a row of measures each few steps, under the column names of LAMMPS where it has one.
class History {
 public:
  /// Begins `path` anew with its header; throws OutputError.
  explicit History(const std::filesystem::path& path);
  /// Goes on with `path` where mark() was taken: later rows are cut off. Throws InputError.
  History(const std::filesystem::path& path, const FileMark& mark) : file_(path, mark) {}

  /// Appends a row and hands it to the system; throws OutputError.
  void add(const Measures& measures);

  /// Brings the rows to the disk and says how far they reach.
  FileMark mark() { return file_.mark(); }

 private:
  AppendFile file_;
};

/// Names of the columns.
std::vector<std::string> history_columns();

/// What they are.
std::vector<OutputField> history_fields();

/// The values of these columns of a history, row by row. Throws InputError.
std::vector<std::vector<double>> read_history(const std::filesystem::path& path,
                                              const std::vector<std::string>& wanted);

}  // namespace furnas
