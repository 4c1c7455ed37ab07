#pragma once

#include <array>
#include <cstdint>
#include <filesystem>

#include "engine/base/vec3.h"
#include "io/atomic_file.h"

namespace furnas {

/// A binary STL file, triangle by triangle.
class StlFile {
 public:
  static constexpr std::uint64_t bytes_of_head = 84, bytes_of_triangle = 50;

  /// Throws OutputError.
  explicit StlFile(const std::filesystem::path& path);

  /// Adds a triangle with these corners [d_s], counter-clockwise as seen from outside. A triangle with two
  /// equal corners is left out. Throws OutputError, and InputError for more than 2^32 - 1 triangles.
  void add(const std::array<Vec3<float>, 3>& corners);

  std::uint32_t triangles() const { return count_; }

  /// Makes the file durable; throws OutputError.
  void commit();

 private:
  AtomicFile file_;
  std::uint32_t count_ = 0;
};

}  // namespace furnas
