#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/file_cell.h"
#include "io/text_reader.h"

namespace furnas {

/// The header of a LAMMPS data file, line by line.
class LammpsHeader {
 public:
  /// Takes a line of words; `names` are the words of the comment after it. Throws InputError for a line it
  /// does not know.
  void take(const TextReader& reader, const std::vector<std::string_view>& words,
            std::vector<std::string> names);
  /// Throws InputError at the reader's line unless the header is complete; cell() is valid afterwards.
  void finish(const TextReader& reader);

  std::size_t count() const { return *count_; }
  const std::optional<std::int64_t>& types() const { return types_; }
  const std::vector<std::string>& names() const { return names_; }
  const FileCell& cell() const { return cell_; }

 private:
  bool take_bounds(const TextReader& reader, const std::vector<std::string_view>& words);
  bool take_edges(const TextReader& reader, const std::vector<std::string_view>& words);

  static constexpr std::size_t least_row = 14;  ///< "1 1 1 1 0 0 0\n"

  std::optional<std::size_t> count_;
  std::optional<std::int64_t> types_;
  std::vector<std::string> names_;  ///< of the types; none, or as many as there are
  std::array<std::optional<std::array<double, 2>>, 3> bounds_;
  Triangle tilts_;
  std::array<std::optional<Vec3<double>>, 3> edges_;  ///< edges of a general triclinic cell
  Vec3<double> corner_;                               ///< origin of a general triclinic cell
  FileCell cell_;
};

}  // namespace furnas
