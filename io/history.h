#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "engine/state/measures.h"
#include "io/append_file.h"
#include "io/output_field.h"

namespace furnas {

/// history.csv: a row of measures every few steps. The names of columns are those of LAMMPS where LAMMPS has
/// one.
class History {
 public:
  /// Creates `path`, or empties an existing file, and writes the header; throws OutputError.
  explicit History(const std::filesystem::path& path);
  /// Continues `path` from an earlier mark() and cuts off later rows. Throws InputError.
  History(const std::filesystem::path& path, const FileMark& mark) : file_(path, mark) {}

  /// Appends a row and hands it to the system; throws OutputError.
  void add(const Measures& measures);

  /// Writes the rows through to the disk and returns the mark of the file.
  FileMark mark() { return file_.mark(); }

 private:
  AppendFile file_;
};

/// Names of the columns.
std::vector<std::string> history_columns();

/// Units and meanings of the columns.
std::vector<OutputField> history_fields();

/// The values of these columns of a history, row by row. Throws InputError.
std::vector<std::vector<double>> read_history(const std::filesystem::path& path,
                                              const std::vector<std::string>& wanted);

}  // namespace furnas
