#pragma once

#include <cstddef>

namespace furnas {

/// Measures by how much the resident memory of this process grows after the construction of this object.
class MemoryWatch {
 public:
  MemoryWatch();
  /// Peak of the memory since then minus the memory at the start, in bytes; 0 where the system does not
  /// report it.
  std::size_t growth() const;

 private:
  std::size_t start_;
};

}  // namespace furnas
