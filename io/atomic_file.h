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
/// The bytes go to `<name>.tmp` in the same folder. commit() writes them through to the disk and renames the
/// file. Without commit() the temporary file is removed, and an older file of that name stays untouched.
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

  /// Overwrites earlier bytes, from byte `at` on: a header may hold numbers that are known only when the rest
  /// of the file is written. Throws OutputError.
  void overwrite(std::uint64_t at, std::string_view bytes);

  /// Makes the file durable under its name; throws OutputError. Nothing may be written afterwards.
  void commit();

 private:
  void flush();
  void write_at(std::uint64_t at, std::string_view bytes);
  [[noreturn]] void fail(const char* what) const;

  std::filesystem::path path_;
  std::filesystem::path temporary_;
  std::string buffer_;         ///< bytes not yet handed to the system
  std::uint64_t flushed_ = 0;  ///< bytes handed to the system
  int descriptor_ = -1;
};

/// Writes a whole file at once, complete or not at all.
void write_file(const std::filesystem::path& path, std::string_view bytes);

/// Throws InputError if there is a file of this name. Called for files whose name the user did not give, and
/// for case files, which a user may have edited; other outputs replace a file of their name.
void refuse_existing(const std::filesystem::path& path);

}  // namespace furnas
