#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "engine/base/hasher.h"
#include "io/atomic_file.h"

namespace furnas {

// A binary file of named arrays; all numbers are little-endian.
//
//   file     magic (8 bytes), version (u32), 0 (u32), sections, trailer
//   section  length of the name (u32), size of an element (u32), number of elements (u64), name, blocks,
//            hash (u64)
//   block    raw size (u32), stored size (u32), a zstd frame; all blocks together are the elements in order
//   trailer  number of sections (u64), size of the file (u64), hash (u64), magic (8 bytes)
//
// The hash of a section is XXH3 over its bytes before the hash, with the raw bytes of each block after its
// frame. The hash of the trailer is XXH3 over the file's first 16 bytes, the hashes of the sections and the
// trailer's first 16 bytes. So no byte of the file can change unnoticed.

/// The beginning of a kind of section file.
struct SectionFormat {
  std::string_view magic;   ///< 8 characters
  std::uint32_t version{};  ///< grows when the sections change
};

/// Most raw bytes in a block. A damaged file can announce any length; this limit bounds the memory that is
/// allocated before the bytes have been read.
inline constexpr std::size_t block_size = std::size_t{1} << 20;

/// Writes a file of sections.
class SectionWriter {
 public:
  SectionWriter(const std::filesystem::path& path, const SectionFormat& format);

  /// Writes a section of `count` elements of type T, which has no padding; `element(k)` gives each.
  template <class T, class Element>
  void array(std::string_view name, std::size_t count, Element element) {
    static_assert(std::is_trivially_copyable_v<T> && !std::is_same_v<T, bool>);
    begin(name, sizeof(T), count);
    std::vector<T> block;
    for (std::size_t first = 0; first < count; first += block.size()) {
      block.resize(std::min(block_size / sizeof(T), count - first));
      for (std::size_t k = 0; k < block.size(); ++k) block[k] = element(first + k);
      add_block(block.data(), block.size() * sizeof(T));
    }
    end();
  }

  /// Writes the trailer and renames the file to its final name.
  void commit();

 private:
  void begin(std::string_view name, std::size_t element_size, std::size_t count);
  void add_block(const void* raw, std::size_t size);
  void end();
  void put(const void* bytes, std::size_t size);

  AtomicFile file_;
  SectionFormat format_;
  Hasher section_hash_, file_hash_;
  std::vector<char> frame_;
  std::uint64_t size_ = 0;      ///< bytes written so far
  std::uint64_t sections_ = 0;  ///< sections written so far
};

/// Reads a file of sections in the order in which they were written. All failures are InputErrors that name
/// file and section.
class SectionReader {
 public:
  /// Opens the file; checks magic, version and the trailer.
  SectionReader(const std::filesystem::path& path, const SectionFormat& format);

  /// Reads the section `name`, which must be the next, and hands its elements to `take(element)` in order.
  /// The hash of the section is checked last, so the elements may be wrong until this returns.
  template <class T, class Take>
  void array(std::string_view name, Take take) {
    static_assert(std::is_trivially_copyable_v<T> && !std::is_same_v<T, bool>);
    begin(name, sizeof(T));
    for (std::span<const char> raw = next_block(); !raw.empty(); raw = next_block()) {
      for (std::size_t at = 0; at < raw.size(); at += sizeof(T)) {
        T element;
        std::memcpy(&element, raw.data() + at, sizeof(T));
        take(element);
      }
    }
    end();
  }

  /// Checks that no section follows, and checks the hash of the whole file.
  void finish();

  /// Throws InputError for the section read last.
  [[noreturn]] void fail(std::string_view what) const;

 private:
  void begin(std::string_view name, std::size_t element_size);
  std::span<const char> next_block();
  void end();
  /// Reads bytes of the current section; there must be that many before the trailer.
  void get(void* bytes, std::size_t size);

  std::string name_;
  std::uint64_t remaining_;  ///< bytes before the trailer
  std::ifstream stream_;
  Hasher section_hash_, file_hash_;
  std::string section_;
  std::uint64_t sections_ = 0;       ///< sections read so far
  std::size_t element_size_ = 0;     ///< of the current section
  std::uint64_t elements_left_ = 0;  ///< of the current section
  std::vector<char> frame_, raw_;
  std::array<std::uint64_t, 3> trailer_{};
};

}  // namespace furnas
