#include "engine/state/fingerprint.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace furnas {
namespace {

Packing example() {
  Packing p;
  p.step = 7;
  p.cell.edges = {.xx = 4, .yy = 5, .zz = 6, .yz = 0.5, .xz = -0.25, .xy = 1};
  p.resize(3);
  for (std::size_t k = 0; k < 3; ++k) {
    const auto x = static_cast<double>(k);
    p.fraction[k] = {k, k + 1, k + 2};
    p.velocity[k] = {x, -x, 0.5};
    p.spin[k] = {0.1, x, 0.2};
  }
  p.contacts.resize(3);
  p.contacts[0].i = 0, p.contacts[0].j = 1, p.contacts[0].history = {1, 2, 3};
  p.contacts[1].i = 0, p.contacts[1].j = 2, p.contacts[1].image = {0, 1, -1};
  p.contacts[2].i = 2, p.contacts[2].j = 2, p.contacts[2].image = {1, 0, 0},
  p.contacts[2].history = {0, 5, 0};
  return p;
}

TEST(StateHash, DependsOnEachPartOfTheState) {
  std::set<std::uint64_t> hashes{state_hash(example())};
  const auto changed = [&](auto change) {
    Packing p = example();
    change(p);
    return hashes.insert(state_hash(p)).second;
  };
  EXPECT_TRUE(changed([](Packing& p) { p.step = 8; }));
  EXPECT_TRUE(changed([](Packing& p) { p.cell.edges.xy += 1e-15; }));
  EXPECT_TRUE(changed([](Packing& p) { p.cell.rate.xy += 1e-15; }));
  EXPECT_TRUE(changed([](Packing& p) { p.fraction[2].z += 1; }));
  EXPECT_TRUE(changed([](Packing& p) { p.velocity[1].y *= 1 + 1e-15; }));
  EXPECT_TRUE(changed([](Packing& p) { p.spin[1].y *= 1 + 1e-15; }));
  EXPECT_TRUE(changed([](Packing& p) { p.contacts[0].history.x *= 1 + 1e-15; }));
  EXPECT_TRUE(changed([](Packing& p) { p.contacts[0].j = 2; }));
  EXPECT_TRUE(changed([](Packing& p) { p.contacts[1].image[1] = 0; }));
  EXPECT_TRUE(changed([](Packing& p) { p.contacts.pop_back(); }));
  EXPECT_TRUE(changed([](Packing& p) { std::swap(p.velocity[0], p.velocity[1]); }));
}

TEST(StateHash, DependsOnNoOrder) {
  const std::uint64_t hash = state_hash(example());
  Packing p = example();
  p.order = {2, 0, 1};
  EXPECT_EQ(state_hash(p), hash);
  std::reverse(p.contacts.begin(), p.contacts.end());
  EXPECT_EQ(state_hash(p), hash);
  for (Contact& c : p.contacts) {  // each seen from its other particle
    std::swap(c.i, c.j);
    for (auto& n : c.image) n = static_cast<std::int8_t>(-n);
    c.history = -c.history;
  }
  EXPECT_EQ(state_hash(p), hash);
}

TEST(StateHash, DependsOnNothingThatFollowsFromTheState) {
  Packing p = example();
  p.force[0] = {1, 2, 3};
  p.contacts[0].force = {1, 2, 3};
  p.contacts[0].sliding = true;
  p.stress.contacts.setOnes();
  EXPECT_EQ(state_hash(p), state_hash(example()));
}

/// A constant: a checkpoint or a log of today can be compared with one of any later version.
TEST(StateHash, IsTheSameOnEveryMachine) { EXPECT_EQ(hex(state_hash(example())), "df3f4886c36addff"); }

TEST(Hex, HasSixteenDigits) {
  EXPECT_EQ(hex(0), "0000000000000000");
  EXPECT_EQ(hex(0x0123456789abcdefu), "0123456789abcdef");
}

}  // namespace
}  // namespace furnas
