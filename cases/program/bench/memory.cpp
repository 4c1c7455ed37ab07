#include "cases/program/bench/memory.h"

#include <malloc.h>

#include <fstream>
#include <sstream>
#include <string>

namespace furnas {
namespace {

/// A line "name:  123 kB" of /proc/self/status, in bytes.
std::size_t status(const std::string& name) {
  std::ifstream file("/proc/self/status");
  for (std::string line; std::getline(file, line);) {
    if (!line.starts_with(name + ":")) continue;
    std::size_t kilobytes = 0;
    std::istringstream(line.substr(name.size() + 1)) >> kilobytes;
    return kilobytes * 1024;
  }
  return 0;
}

}  // namespace

MemoryWatch::MemoryWatch() {
  ::malloc_trim(0);                             // memory that is free already must not hide growth later
  std::ofstream("/proc/self/clear_refs") << 5;  // resets the peak of the resident memory
  start_ = status("VmRSS");
}

std::size_t MemoryWatch::growth() const {
  const std::size_t peak = status("VmHWM");
  return peak > start_ ? peak - start_ : 0;
}

}  // namespace furnas
