#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/vec3.h"
#include "io/text_reader.h"

namespace furnas {

/// The named columns of a table in a text file, and the words of its current row.
class Columns {
 public:
  /// Sets the names; throws InputError if one occurs twice.
  void name(const TextReader& reader, std::vector<std::string> names);
  /// Takes a row; throws InputError unless it has one word for each name.
  void row(const TextReader& reader, std::vector<std::string_view> words);

  bool has(std::string_view name) const { return find(name) != none; }
  bool has_all(const std::vector<std::string>& names) const;
  /// The word in the column, which must exist.
  std::string_view word(std::string_view name) const { return words_[find(name)]; }
  /// The number in the column, or `missing` if there is no such column.
  double real(std::string_view name, double missing = 0) const;
  /// The whole number in the column, or `missing` if there is no such column.
  std::int64_t integer(std::string_view name, std::int64_t missing = 0) const;
  /// The type of a particle, 1 or more; 0 if there is no such column.
  std::int32_t type(std::string_view name) const;
  /// Cells crossed along an edge, or 0 if there is no such column.
  std::int32_t image(std::string_view name) const;
  /// Three columns as a vector; a missing column counts as zero.
  Vec3<double> vector(std::string_view x, std::string_view y, std::string_view z) const {
    return {real(x), real(y), real(z)};
  }

 private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  std::size_t find(std::string_view name) const;

  const TextReader* reader_ = nullptr;
  std::vector<std::string> names_;
  std::vector<std::string_view> words_;
};

}  // namespace furnas
