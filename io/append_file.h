#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "engine/base/hasher.h"

namespace furnas {

/// Length and hash of a growing file at one moment.
struct FileMark {
  std::uint64_t bytes{};  ///< its length
  std::uint64_t hash{};   ///< XXH3 of those bytes
  friend bool operator==(const FileMark&, const FileMark&) = default;
};

/// Converts a mark to text, "1234 bytes 00112233aabbccdd", and back; the latter throws InputError.
std::string to_text(const FileMark& mark);
FileMark parse_mark(const std::string& text);

/// A file that only grows, and that can be cut back to its length at a checkpoint.
class AppendFile {
 public:
  /// Creates the file, or empties an existing one; throws OutputError.
  explicit AppendFile(std::filesystem::path path);
  /// Continues the file at a mark and cuts off what follows. Throws InputError unless the bytes before the
  /// mark are the marked ones.
  AppendFile(std::filesystem::path path, const FileMark& mark);
  ~AppendFile();
  AppendFile(const AppendFile&) = delete;
  AppendFile& operator=(const AppendFile&) = delete;

  /// Appends bytes and hands them to the operating system. If this fails, throws OutputError and restores the
  /// old length of the file.
  void append(std::string_view bytes);

  /// Writes the file through to the disk and returns its mark; throws OutputError.
  FileMark mark();

 private:
  void take_up(const FileMark& mark);
  [[noreturn]] void fail(const char* what) const;

  std::filesystem::path path_;
  int descriptor_ = -1;
  std::uint64_t bytes_ = 0;
  Hasher hasher_;
};

}  // namespace furnas
