#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <type_traits>

namespace furnas {

static_assert(std::endian::native == std::endian::little, "hashes are defined for little-endian numbers");

/// The 64-bit hash XXH3 of bytes that are added piece by piece.
class Hasher {
 public:
  Hasher();
  /// Forgets all bytes.
  void restart();
  void add_bytes(const void* bytes, std::size_t size);
  /// Adds numbers, or structs of numbers, which must have no padding.
  template <class T>
  void add(std::span<const T> values) {
    static_assert(std::is_trivially_copyable_v<T>);
    add_bytes(values.data(), values.size_bytes());
  }
  template <class T>
  void add(const T& value) {
    add(std::span<const T>(&value, 1));
  }
  /// The hash of all bytes so far.
  std::uint64_t value() const;

 private:
  struct State;
  struct Free {
    void operator()(State* state) const;
  };
  std::unique_ptr<State, Free> state_;
};

}  // namespace furnas
