#pragma once

#include <filesystem>
#include <string>

namespace furnas {

/// The most memory that this process may have, and the source of this limit.
struct MemoryLimit {
  double bytes{};
  std::string source;  ///< words before the number, such as "this machine has" before "8 GB"
};

/// The smallest of three limits: the memory of the machine, the limit of the process's control groups
/// (version 1 or 2), and the limit set with ulimit. Tests replace "/" by another `root`.
MemoryLimit memory_limit(const std::filesystem::path& root = "/");

}  // namespace furnas
