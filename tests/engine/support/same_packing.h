#pragma once

#include <gtest/gtest.h>

#include <bit>
#include <cstring>

#include "engine/state/packing.h"

namespace furnas::test {

inline bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}
inline bool same_bits(const Vec3<double>& a, const Vec3<double>& b) {
  return same_bits(a.x, b.x) && same_bits(a.y, b.y) && same_bits(a.z, b.z);
}
inline bool same_bits(const Triangle& a, const Triangle& b) {
  return same_bits(a.xx, b.xx) && same_bits(a.yy, b.yy) && same_bits(a.zz, b.zz) && same_bits(a.yz, b.yz) &&
         same_bits(a.xz, b.xz) && same_bits(a.xy, b.xy);
}
inline bool same_bits(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b) {
  return std::memcmp(a.data(), b.data(), 9 * sizeof(double)) == 0;
}
inline bool same_bits(const Contact& a, const Contact& b) {
  return a.i == b.i && a.j == b.j && a.image == b.image && same_bits(a.branch, b.branch) &&
         same_bits(a.overlap, b.overlap) && same_bits(a.force, b.force) && same_bits(a.history, b.history) &&
         a.sliding == b.sliding;
}
inline bool same_bits(const Losses& a, const Losses& b) {
  return same_bits(a.normal_damping, b.normal_damping) &&
         same_bits(a.tangential_damping, b.tangential_damping) && same_bits(a.sliding, b.sliding) &&
         same_bits(a.opening, b.opening);
}
inline bool same_bits(const Ledger& a, const Ledger& b) {
  return same_bits(a.initial, b.initial) && same_bits(a.cell_work, b.cell_work) &&
         same_bits(a.losses, b.losses) && same_bits(a.quenched, b.quenched) &&
         same_bits(a.last.push, b.last.push) && same_bits(a.last.losses, b.last.losses);
}
template <class T>
bool same_bits(const T& a, const T& b) {
  return a == b;
}

/// Whether two packings are the same bit for bit, in every field but the ledger; names the first that
/// differs. The sums of the ledger are rounded in the order of the neighbour list, which depends on the skin.
inline ::testing::AssertionResult same_state(const Packing& a, const Packing& b) {
  const auto differ = [](const char* what, std::size_t k) {
    return ::testing::AssertionFailure() << what << " differs, first at " << k;
  };
  const auto field = [&](const char* what, const auto& x, const auto& y) -> ::testing::AssertionResult {
    if (x.size() != y.size())
      return ::testing::AssertionFailure() << what << ": " << x.size() << " and " << y.size() << " of them";
    for (std::size_t k = 0; k < x.size(); ++k)
      if (!same_bits(x[k], y[k])) return differ(what, k);
    return ::testing::AssertionSuccess();
  };
  if (a.step != b.step) return differ("step", 0);
  if (!same_bits(a.time, b.time)) return differ("time", 0);
  ::testing::AssertionResult result = ::testing::AssertionSuccess();
  (void)((result = field("species", a.species, b.species)) &&
         (result = field("radius", a.radius, b.radius)) && (result = field("mass", a.mass, b.mass)) &&
         (result = field("fraction", a.fraction, b.fraction)) &&
         (result = field("image", a.image, b.image)) &&
         (result = field("velocity", a.velocity, b.velocity)) && (result = field("spin", a.spin, b.spin)) &&
         (result = field("force", a.force, b.force)) && (result = field("torque", a.torque, b.torque)) &&
         (result = field("contacts", a.contacts, b.contacts)) && (result = field("order", a.order, b.order)));
  if (!result) return result;
  if (!same_bits(a.cell.edges, b.cell.edges)) return differ("edges of the cell", 0);
  if (!same_bits(a.cell.rate, b.cell.rate)) return differ("rate of the cell", 0);
  if (!same_bits(a.stress.contacts, b.stress.contacts)) return differ("stress of contacts", 0);
  if (!same_bits(a.stress.motion, b.stress.motion)) return differ("stress of motion", 0);
  if (a.labels != b.labels) return differ("labels", 0);
  return ::testing::AssertionSuccess();
}

/// Whether two packings are the same bit for bit, in every field; names the first that differs.
inline ::testing::AssertionResult same_packing(const Packing& a, const Packing& b) {
  if (const auto same = same_state(a, b); !same) return same;
  if (!same_bits(a.ledger, b.ledger)) return ::testing::AssertionFailure() << "ledger differs";
  return ::testing::AssertionSuccess();
}

}  // namespace furnas::test
