#pragma once

#include <filesystem>
#include <string>

namespace furnas {

/// The most memory that this process may have, and who says so.
struct MemoryLimit {
  double bytes{};
  std::string source;  ///< completes "... has 8 GB": "this machine has"
};

/// The least of what the machine has, what its control groups allow (either version) and what the shell has
/// set with ulimit. `root` stands for "/", for tests.
MemoryLimit memory_limit(const std::filesystem::path& root = "/");

}  // namespace furnas
