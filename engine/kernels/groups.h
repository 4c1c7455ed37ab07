#pragma once

#include <cstring>

#include "engine/kernels/lanes.h"

// Records of particles store numbers in groups of four; lanes hold one number of many particles. These
// functions convert between both within registers, which is faster than a hardware gather.
namespace furnas::HWY_NAMESPACE {

#if HWY_TARGET != HWY_SCALAR
namespace detail {

template <class T>
constexpr std::size_t in_block = 16 / sizeof(T);  ///< numbers in 128 bits

/// A register filled with 128 bits each from address(first), address(first + in_block), ...
template <class T, class Address>
HWY_INLINE hn::Vec<Tag<T>> side_by_side(std::size_t first, Address&& address) {
  const auto block = [&](std::size_t b) { return address(first + b * in_block<T>); };
#if HWY_TARGET == HWY_AVX3
  const auto bits = [&](std::size_t b) { return _mm_loadu_ps(reinterpret_cast<const float*>(block(b))); };
  __m512 v = _mm512_castps128_ps512(bits(0));
  v = _mm512_insertf32x4(v, bits(1), 1);
  v = _mm512_insertf32x4(v, bits(2), 2);
  v = _mm512_insertf32x4(v, bits(3), 3);
  return hn::BitCast(Tag<T>(), hn::Vec<Tag<float>>{v});
#elif HWY_TARGET == HWY_AVX2
  const auto bits = [&](std::size_t b) { return _mm_loadu_ps(reinterpret_cast<const float*>(block(b))); };
  return hn::BitCast(Tag<T>(),
                     hn::Vec<Tag<float>>{_mm256_insertf128_ps(_mm256_castps128_ps256(bits(0)), bits(1), 1)});
#else
  return hn::LoadU(Tag<T>(), block(0));
#endif
}

/// The inverse of side_by_side(): writes 128 bits each to address(first), address(first + in_block), ..., for
/// indices below `count`.
template <class T, class Address>
HWY_INLINE void take_apart(const hn::Vec<Tag<T>>& v, std::size_t first, std::size_t count,
                           Address&& address) {
#if HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_AVX2
  const auto put = [&](std::size_t b, const __m128& bits) {
    const std::size_t to = first + b * in_block<T>;
    if (to < count) _mm_storeu_ps(reinterpret_cast<float*>(address(to)), bits);
  };
#endif
#if HWY_TARGET == HWY_AVX3
  const __m512 all = hn::BitCast(Tag<float>(), v).raw;
  put(0, _mm512_castps512_ps128(all));
  put(1, _mm512_extractf32x4_ps(all, 1));
  put(2, _mm512_extractf32x4_ps(all, 2));
  put(3, _mm512_extractf32x4_ps(all, 3));
#elif HWY_TARGET == HWY_AVX2
  const __m256 all = hn::BitCast(Tag<float>(), v).raw;
  put(0, _mm256_castps256_ps128(all));
  put(1, _mm256_extractf128_ps(all, 1));
#else
  if (first < count) hn::StoreU(v, Tag<T>(), address(first));
#endif
}

HWY_INLINE hn::Vec<Tag<float>> lower_pairs(const hn::Vec<Tag<float>>& a, const hn::Vec<Tag<float>>& b) {
  const Tag<double> d;
  return hn::BitCast(Tag<float>(), hn::InterleaveLower(d, hn::BitCast(d, a), hn::BitCast(d, b)));
}
HWY_INLINE hn::Vec<Tag<float>> upper_pairs(const hn::Vec<Tag<float>>& a, const hn::Vec<Tag<float>>& b) {
  const Tag<double> d;
  return hn::BitCast(Tag<float>(), hn::InterleaveUpper(d, hn::BitCast(d, a), hn::BitCast(d, b)));
}

}  // namespace detail
#endif

/// Four lanes that belong together.
template <class T>
struct Group {
  Lanes<T> a, b, c, d;
};

/// Loads the four numbers at address(l) into lane l of a, b, c and d.
template <class T, class Address>
HWY_INLINE Group<T> load_groups(Address&& address) {
  Group<T> g;
#if HWY_TARGET == HWY_SCALAR
  const T* from = address(0);
  g.a = Lanes<T>::from(from), g.b = Lanes<T>::from(from + 1);
  g.c = Lanes<T>::from(from + 2), g.d = Lanes<T>::from(from + 3);
#else
  using namespace detail;
  const Tag<T> d;
  if constexpr (sizeof(T) == 4) {
    const auto r0 = side_by_side<T>(0, address), r1 = side_by_side<T>(1, address);
    const auto r2 = side_by_side<T>(2, address), r3 = side_by_side<T>(3, address);
    const auto ab_01 = hn::InterleaveLower(d, r0, r1), ab_23 = hn::InterleaveLower(d, r2, r3);
    const auto cd_01 = hn::InterleaveUpper(d, r0, r1), cd_23 = hn::InterleaveUpper(d, r2, r3);
    g.a.v = lower_pairs(ab_01, ab_23), g.b.v = upper_pairs(ab_01, ab_23);
    g.c.v = lower_pairs(cd_01, cd_23), g.d.v = upper_pairs(cd_01, cd_23);
  } else {
    const auto second = [&](std::size_t l) { return address(l) + 2; };
    const auto ab_0 = side_by_side<T>(0, address), ab_1 = side_by_side<T>(1, address);
    const auto cd_0 = side_by_side<T>(0, second), cd_1 = side_by_side<T>(1, second);
    g.a.v = hn::InterleaveLower(d, ab_0, ab_1), g.b.v = hn::InterleaveUpper(d, ab_0, ab_1);
    g.c.v = hn::InterleaveLower(d, cd_0, cd_1), g.d.v = hn::InterleaveUpper(d, cd_0, cd_1);
  }
#endif
  return g;
}

/// Writes lane l of a, b, c and d to address(l), for l below `count`.
template <class T, class Address>
HWY_INLINE void store_groups(const Group<T>& g, std::size_t count, Address&& address) {
#if HWY_TARGET == HWY_SCALAR
  if (count == 0) return;
  T* to = address(0);
  g.a.to(to), g.b.to(to + 1), g.c.to(to + 2), g.d.to(to + 3);
#else
  using namespace detail;
  const Tag<T> d;
  const auto ab_low = hn::InterleaveLower(d, g.a.v, g.b.v), ab_high = hn::InterleaveUpper(d, g.a.v, g.b.v);
  const auto cd_low = hn::InterleaveLower(d, g.c.v, g.d.v), cd_high = hn::InterleaveUpper(d, g.c.v, g.d.v);
  if constexpr (sizeof(T) == 4) {
    take_apart<T>(lower_pairs(ab_low, cd_low), 0, count, address);
    take_apart<T>(upper_pairs(ab_low, cd_low), 1, count, address);
    take_apart<T>(lower_pairs(ab_high, cd_high), 2, count, address);
    take_apart<T>(upper_pairs(ab_high, cd_high), 3, count, address);
  } else {
    const auto second = [&](std::size_t l) { return address(l) + 2; };
    take_apart<T>(ab_low, 0, count, address), take_apart<T>(ab_high, 1, count, address);
    take_apart<T>(cd_low, 0, count, second), take_apart<T>(cd_high, 1, count, second);
  }
#endif
}

/// Writes the lanes whose bit is set to consecutive places from `to` on. Up to a whole register of memory
/// from `to` on may be overwritten.
template <class T>
HWY_INLINE void pack(const Lanes<T>& values, unsigned bits, T* to) {
#if HWY_TARGET == HWY_AVX3
  // Highway 1.0.3 compresses 64-bit lanes with a table that it copies at each call, so the intrinsic is used
  // instead.
  static_assert(sizeof(T) == 8);
  _mm512_storeu_pd(to, _mm512_maskz_compress_pd(static_cast<__mmask8>(bits), values.v.raw));
#else
  T all[Lanes<T>::count];
  values.to(all);
  for (; bits != 0; bits &= bits - 1) *to++ = all[__builtin_ctz(bits)];
#endif
}

}  // namespace furnas::HWY_NAMESPACE
