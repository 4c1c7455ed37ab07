#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "engine/base/hasher.h"

namespace furnas {

/// How far a file that grows has come.
struct FileMark {
  std::uint64_t bytes{};  ///< its length
  std::uint64_t hash{};   ///< XXH3 of those bytes
  friend bool operator==(const FileMark&, const FileMark&) = default;
};

/// The mark as text, "1234 bytes 00112233aabbccdd", and back; throws InputError.
std::string to_text(const FileMark& mark);
FileMark parse_mark(const std::string& text);

/// A file that only grows, and that can be cut back to where it was when a run was saved.
class AppendFile {
 public:
  /// Begins the file anew; throws OutputError.
  explicit AppendFile(std::filesystem::path path);
  /// Goes on with the file at a mark: what follows the mark is cut off. Throws InputError unless what
  /// precedes it is what was marked.
  AppendFile(std::filesystem::path path, const FileMark& mark);
  ~AppendFile();
  AppendFile(const AppendFile&) = delete;
  AppendFile& operator=(const AppendFile&) = delete;

  /// Appends bytes and hands them to the system; throws OutputError, and the file ends where it did before.
  void append(std::string_view bytes);

  /// Brings the file to the disk and says how far it has come; throws OutputError.
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
