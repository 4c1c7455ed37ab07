#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

namespace furnas {

/// Another process works in the folder.
struct FolderInUse : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// While this object exists, no other run can take the folder. It holds a lock of the operating system on a
/// file in the folder. A process loses the lock in whatever way it ends. The destructor removes the file.
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
