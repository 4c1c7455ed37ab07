#pragma once

#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

namespace furnas {

/// A file could not be written: no such folder, no permission, disk full; the message names the file.
struct OutputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A file that appears under its name complete or not at all.
///
/// The file is written as `<name>.tmp` beside its place. commit() brings it to the disk and renames it; a
/// file that is not committed leaves an older one of that name untouched and vanishes.
class AtomicFile {
 public:
  /// Creates `<path>.tmp`; throws OutputError.
  explicit AtomicFile(std::filesystem::path path);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  /// Appends bytes; throws OutputError.
  void write(std::string_view bytes);

  /// Bytes written so far.
  std::uint64_t size() const { return flushed_ + buffer_.size(); }

  /// Puts other bytes in the place of some that were written, `at` bytes after the beginning: numbers that
  /// are known only when what follows them is. Throws OutputError.
  void overwrite(std::uint64_t at, std::string_view bytes);

  /// Makes the file durable under its name; throws OutputError. Nothing may be written afterwards.
  void commit();

 private:
  void flush();
  void write_at(std::uint64_t at, std::string_view bytes);
  [[noreturn]] void fail(const char* what) const;

  std::filesystem::path path_;
  std::filesystem::path temporary_;
  std::string buffer_;         ///< bytes that follow those the system has
  std::uint64_t flushed_ = 0;  ///< bytes that the system has
  int descriptor_ = -1;
};

/// Writes a whole file at once, complete or not at all.
void write_file(const std::filesystem::path& path, std::string_view bytes);

}  // namespace furnas
