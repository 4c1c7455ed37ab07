#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace furnas {

/// Throws InputError unless `path` is a file that can be read; returns its size in bytes.
std::uint64_t readable_size(const std::filesystem::path& path);

/// Opens a file. Throws InputError if it cannot be opened, and std::bad_alloc if memory is missing; a plain
/// stream without memory would look like an empty file.
std::ifstream open_file(const std::filesystem::path& path);

/// Calls `visit` with one part after the other of what is left in an open file, which may be larger than the
/// memory. Throws InputError with `path` if the file cannot be read to its end.
void read_in_parts(std::ifstream& file, const std::filesystem::path& path,
                   const std::function<void(std::string_view)>& visit);

/// The content of a file; throws as open_file does, and InputError if the file cannot be read to its end.
std::string read_file(const std::filesystem::path& path);

/// Reads the next line, without its line end; false after the last. Throws std::bad_alloc, and
/// std::ios_base::failure if the stream cannot be read any further; std::getline would treat both as the end
/// of the file.
bool read_line(std::istream& stream, std::string& line);

/// A text file, line by line, and the numbers in its lines. Each failure names file and line.
class TextReader {
 public:
  /// Opens the file; throws InputError.
  explicit TextReader(const std::filesystem::path& path);

  /// Goes to the next line; false at the end of the file. A last line without a line end is refused unless it
  /// is blank, because the file may have been cut short there, perhaps within a number.
  bool next_line();
  /// Goes to the next line; `expected` names what is missing if there is none.
  void require_line(std::string_view expected);
  /// The current line without its end.
  const std::string& line() const { return line_; }
  /// Counted from 1; 0 before the first.
  std::int64_t line_number() const { return line_number_; }
  /// Words of the current line, between blanks; what follows the character `comment` is left out.
  std::vector<std::string_view> words(char comment = '\0') const;

  /// Throws InputError with file and line.
  [[noreturn]] void fail(std::string_view what) const { fail_at(line_number_, what); }
  /// The same for an earlier line; 0 names the file alone.
  [[noreturn]] void fail_at(std::int64_t line, std::string_view what) const;

  /// A finite real number; `name` says what it is.
  double real(std::string_view word, std::string_view name) const;
  /// A finite real number above zero.
  double positive(std::string_view word, std::string_view name) const;
  /// A whole number.
  std::int64_t integer(std::string_view word, std::string_view name) const;
  /// The type of a particle: 1 to `most_types`.
  std::int32_t particle_type(std::string_view word) const;
  /// Cells that a particle has crossed along an edge, up to 1e9.
  std::int32_t image(std::string_view word) const;
  /// The number of particles that follow: at least one, and no more than the file can contain if each takes
  /// `least_bytes`.
  std::size_t particle_count(std::string_view word, std::size_t least_bytes) const;

 private:
  std::string name_;
  std::uint64_t size_;
  std::ifstream stream_;
  std::string line_;
  std::int64_t line_number_ = 0;
};

}  // namespace furnas
