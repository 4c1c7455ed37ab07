#pragma once

#include <cstddef>

#define HWY_COMPILE_ONLY_STATIC
#include <hwy/highway.h>

// Each translation unit with kernels is compiled for one instruction set. Highway's namespace, which contains
// everything that depends on the set, has the name of the set. Therefore the linker cannot replace a function
// by the same function compiled for another set.
namespace furnas::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

template <class T>
using Tag = hn::ScalableTag<T>;

/// Prefetches, for writing, the cache lines of records that will be written soon, because another core may
/// hold them.
template <class Record>
HWY_INLINE void fetch_to_write(const Record* records, std::size_t count) {
  const char* const bytes = reinterpret_cast<const char*>(records);
  for (std::size_t at = 0; at < count * sizeof(Record); at += 64) __builtin_prefetch(bytes + at, 1);
}

/// A truth value for each lane.
template <class T>
struct Truths {
  hn::Mask<Tag<T>> mask;

  friend HWY_INLINE Truths operator&(const Truths& a, const Truths& b) { return {hn::And(a.mask, b.mask)}; }
  friend HWY_INLINE Truths operator|(const Truths& a, const Truths& b) { return {hn::Or(a.mask, b.mask)}; }
};

/// As many numbers as the processor computes with in one instruction. Each lane is computed and rounded like
/// a single number, so no result depends on the instruction set or on the position in the lanes.
template <class T>
struct Lanes {
  using Number = T;
  static constexpr std::size_t count = HWY_LANES(T);

  hn::Vec<Tag<T>> v;

  Lanes() : v(hn::Zero(Tag<T>())) {}
  explicit Lanes(double all) : v(hn::Set(Tag<T>(), static_cast<T>(all))) {}
  explicit Lanes(hn::Vec<Tag<T>> lanes) : v(lanes) {}
  static HWY_INLINE Lanes from(const T* numbers) { return Lanes(hn::LoadU(Tag<T>(), numbers)); }
  /// Lanes that hold the bits of whole numbers.
  static HWY_INLINE Lanes from_bits(const hwy::MakeUnsigned<T>* numbers) {
    return Lanes(hn::BitCast(Tag<T>(), hn::LoadU(Tag<hwy::MakeUnsigned<T>>(), numbers)));
  }
  HWY_INLINE void to(T* numbers) const { hn::StoreU(v, Tag<T>(), numbers); }

  friend HWY_INLINE Lanes operator+(const Lanes& a, const Lanes& b) { return Lanes(hn::Add(a.v, b.v)); }
  friend HWY_INLINE Lanes operator-(const Lanes& a, const Lanes& b) { return Lanes(hn::Sub(a.v, b.v)); }
  friend HWY_INLINE Lanes operator*(const Lanes& a, const Lanes& b) { return Lanes(hn::Mul(a.v, b.v)); }
  friend HWY_INLINE Lanes operator/(const Lanes& a, const Lanes& b) { return Lanes(hn::Div(a.v, b.v)); }
  friend HWY_INLINE Lanes operator-(const Lanes& a) { return Lanes(hn::Neg(a.v)); }
  HWY_INLINE Lanes& operator+=(const Lanes& b) { return *this = *this + b; }

  friend HWY_INLINE Truths<T> operator>(const Lanes& a, const Lanes& b) { return {hn::Gt(a.v, b.v)}; }
  friend HWY_INLINE Truths<T> operator<(const Lanes& a, const Lanes& b) { return {hn::Lt(a.v, b.v)}; }
  friend HWY_INLINE Truths<T> operator<=(const Lanes& a, const Lanes& b) { return {hn::Le(a.v, b.v)}; }
  friend HWY_INLINE Truths<T> operator==(const Lanes& a, const Lanes& b) { return {hn::Eq(a.v, b.v)}; }

  friend HWY_INLINE Lanes sqrt(const Lanes& a) { return Lanes(hn::Sqrt(a.v)); }
  friend HWY_INLINE Lanes abs(const Lanes& a) { return Lanes(hn::Abs(a.v)); }
  friend HWY_INLINE Lanes larger(const Lanes& a, const Lanes& b) { return Lanes(hn::Max(a.v, b.v)); }
  friend HWY_INLINE Lanes select(const Truths<T>& first, const Lanes& a, const Lanes& b) {
    return Lanes(hn::IfThenElse(first.mask, a.v, b.v));
  }
};

}  // namespace furnas::HWY_NAMESPACE
