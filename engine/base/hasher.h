#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <span>
#include <type_traits>

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace furnas {

static_assert(std::endian::native == std::endian::little, "hashes are defined for little-endian numbers");

/// The 64-bit hash XXH3 of bytes that come piece by piece.
class Hasher {
 public:
  Hasher() : state_(XXH3_createState()) {
    if (!state_) throw std::bad_alloc();
    restart();
  }
  /// Forgets all bytes.
  void restart() { XXH3_64bits_reset(state_.get()); }
  void add_bytes(const void* bytes, std::size_t size) { XXH3_64bits_update(state_.get(), bytes, size); }
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
  std::uint64_t value() const { return XXH3_64bits_digest(state_.get()); }

 private:
  struct Free {
    void operator()(XXH3_state_t* state) const { XXH3_freeState(state); }
  };
  std::unique_ptr<XXH3_state_t, Free> state_;
};

}  // namespace furnas
