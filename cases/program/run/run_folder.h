#pragma once

#include <chrono>
#include <filesystem>
#include <memory>
#include <string>

#include "cases/program/run/folder_lock.h"

namespace furnas {

/// Makes the folder that --out names, and the folders above it. Throws InputError, for example when there is
/// a file of that name, and OutputError when the disk fails.
void make_folder(const std::filesystem::path& folder);

/// The folder of a run, which no other run can take while this object exists.
class RunFolder {
 public:
  /// Makes a folder: `wanted`, which must be new or empty, or runs/<case>, with a number when that name is
  /// taken. Unless keep() is called, the destructor removes all files in it. Throws InputError, FolderInUse,
  /// OutputError.
  static RunFolder create(const std::string& wanted, const std::filesystem::path& case_file);

  /// Takes the folder of a run that was stopped, and removes the unfinished files of a process that was
  /// killed. Throws InputError, FolderInUse, OutputError.
  static RunFolder open(const std::string& folder);

  RunFolder(RunFolder&&) = default;
  ~RunFolder();

  const std::filesystem::path& path() const { return path_; }

  /// From now on the folder contains files that must be kept.
  void keep() { kept_ = true; }

 private:
  RunFolder(std::filesystem::path path, bool made);

  std::filesystem::path path_;
  std::unique_ptr<FolderLock> lock_;  ///< empty once moved from
  bool made_;                         ///< by this process
  bool kept_ = false;
};

/// "90s", "30m", "2h" or "1d", the value of an option; throws InputError.
std::chrono::seconds parse_duration(const std::string& text, const std::string& option = "--walltime");

}  // namespace furnas
