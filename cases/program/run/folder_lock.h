#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

namespace furnas {

/// Another process works in the folder.
struct FolderInUse : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// While it lives, no other run can take the folder. The lock is a lock of the system on a file in the
/// folder, which a process loses however it ends; the file is removed at last.
class FolderLock {
 public:
  /// The file that is locked; it names the process.
  static constexpr const char* file_name = "run.lock";

  /// Throws FolderInUse, or OutputError if the file cannot be written.
  explicit FolderLock(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  bool try_once();

  std::filesystem::path path_;
  int descriptor_ = -1;
};

}  // namespace furnas
