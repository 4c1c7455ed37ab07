#pragma once

#include <cstddef>

namespace furnas {

/// Watches how far the resident memory of this process grows from where it stands.
class MemoryWatch {
 public:
  MemoryWatch();
  /// Bytes at the peak since then beyond those at the start; 0 where the system does not tell.
  std::size_t growth() const;

 private:
  std::size_t start_;
};

}  // namespace furnas
