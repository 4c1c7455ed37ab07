#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <functional>
#include <span>
#include <string_view>
#include <type_traits>
#include <vector>

#include "engine/base/vec3.h"

namespace furnas {

/// The number type of an element of an array: its own type, or that of the components of a vector.
template <class T>
T component_of(const T&);
template <class T>
T component_of(const Vec3<T>&);
template <class T, std::size_t size>
T component_of(const std::array<T, size>&);

/// The name of a type of numbers in VTK XML files.
constexpr std::string_view vtk_type(double) { return "Float64"; }
constexpr std::string_view vtk_type(std::uint8_t) { return "UInt8"; }
constexpr std::string_view vtk_type(std::int32_t) { return "Int32"; }
constexpr std::string_view vtk_type(std::int64_t) { return "Int64"; }

/// An array of a VTP file. Its elements are computed while the file is written, a block at a time, so that
/// arrays derived from other arrays need no memory.
struct DataArray {
  std::string_view name;
  std::string_view type;       ///< of its numbers, as VTK names it
  std::size_t count{};         ///< elements
  std::size_t components{};    ///< numbers in an element
  std::size_t element_size{};  ///< bytes of an element
  /// Fills a block with the bytes of whole elements, from the element `first` on.
  std::function<void(std::size_t first, std::span<char> block)> fill;
};

/// An array of `count` elements: numbers, vectors, or std::arrays of numbers; `element(k)` gives each.
template <class Element>
DataArray data_array(std::string_view name, std::size_t count, Element element) {
  using T = std::remove_cvref_t<decltype(element(std::size_t{}))>;
  using Number = decltype(component_of(std::declval<T>()));
  static_assert(std::is_trivially_copyable_v<T> && sizeof(T) % sizeof(Number) == 0);
  return {.name = name,
          .type = vtk_type(Number{}),
          .count = count,
          .components = sizeof(T) / sizeof(Number),  // NOLINT(bugprone-sizeof-expression): 1 for a number
          .element_size = sizeof(T),
          .fill = [element](std::size_t first, std::span<char> block) {
            for (std::size_t at = 0; at < block.size(); at += sizeof(T)) {
              const T value = element(first++);
              std::memcpy(block.data() + at, &value, sizeof(T));
            }
          }};
}

/// What VTK calls poly data: points, cells made of them, and arrays of numbers.
struct PolyData {
  DataArray points;
  std::size_t points_of_a_cell{};  ///< 1: each point is a vertex; 2: each two consecutive points are a line
  std::vector<DataArray> field{};  ///< of the whole
  std::vector<DataArray> of_points{};  ///< an element for each point
  std::vector<DataArray> of_cells{};   ///< an element for each vertex or line
};

/// Writes a VTK XML file (.vtp) of raw appended data, compressed with zlib; throws OutputError.
void write_poly_data(const PolyData& data, const std::filesystem::path& path);

}  // namespace furnas
