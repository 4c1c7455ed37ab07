#include "cases/program/memory_limit.h"

#include <sys/resource.h>
#include <unistd.h>

#include <fstream>
#include <vector>

namespace furnas {
namespace {

namespace fs = std::filesystem;

void lower(MemoryLimit& limit, double bytes, const char* source) {
  if (bytes > 0 && bytes < limit.bytes) limit = {bytes, source};
}

/// The folders of the control groups of this process, with the name of the file that contains a limit.
std::vector<fs::path> limit_files(const fs::path& root) {
  const fs::path groups = root / "sys/fs/cgroup";
  std::vector<fs::path> files;
  std::ifstream list(root / "proc/self/cgroup");
  for (std::string line; std::getline(list, line);) {
    const auto first = line.find(':');
    const auto second = line.find(':', first + 1);
    if (second == std::string::npos) continue;
    const std::string controllers = line.substr(first + 1, second - first - 1);
    const bool unified = controllers.empty();
    if (!unified && controllers != "memory") continue;
    const fs::path top = unified ? groups : groups / "memory";
    // Every group above limits this process, too. Within a container the path may not exist; then the top
    // group is used.
    fs::path group = top / fs::path(line.substr(second + 1)).relative_path();
    for (;; group = group.parent_path()) {
      files.push_back(group / (unified ? "memory.max" : "memory.limit_in_bytes"));
      if (group == top || group == group.parent_path()) break;
    }
  }
  return files;
}

}  // namespace

MemoryLimit memory_limit(const fs::path& root) {
  MemoryLimit limit{
      static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGE_SIZE)),
      "this machine has"};
  for (const fs::path& file : limit_files(root)) {
    double bytes = 0;
    std::ifstream(file) >> bytes;  // the word "max" is read as 0: no limit
    lower(limit, bytes, "its control group allows");
  }
  for (const auto resource : {RLIMIT_AS, RLIMIT_DATA}) {
    struct rlimit set {};
    if (getrlimit(resource, &set) == 0 && set.rlim_cur != RLIM_INFINITY)
      lower(limit, static_cast<double>(set.rlim_cur), "ulimit allows");
  }
  return limit;
}

}  // namespace furnas
