#include "engine/search/size_classes.h"

#include <gtest/gtest.h>

#include "engine/trials/listed.h"
#include "tests/engine/support/property.h"
#include "tests/engine/support/random_packing.h"

namespace furnas {
namespace {

TEST(SizeClasses, OneForOneSizeTwoForTwo) {
  EXPECT_EQ(size_classes({0.5, 0.5, 0.5}).size(), 1u);
  EXPECT_EQ(size_classes({0.7, 0.5, 0.5}).size(), 1u);  // alike enough for one grid
  const auto two = size_classes({1.5, 1.5, 0.5, 0.5, 0.5});
  ASSERT_EQ(two.size(), 2u);
  EXPECT_EQ(two[0].first, 0u);
  EXPECT_EQ(two[0].last, 2u);
  EXPECT_EQ(two[0].largest_radius, 1.5);
  EXPECT_EQ(two[1].first, 2u);
  EXPECT_EQ(two[1].last, 5u);
  EXPECT_EQ(two[1].smallest_radius, 0.5);
}

/// 1.2 is wider than 1.5 x 0.8 by the rounding of `double`, and not by that of `float`.
TEST(SizeClasses, AreTheSameInBothPrecisions) {
  Packing p;
  p.resize(3);
  p.radius = {0.8, 1.2, 0.5};
  for (std::uint64_t k = 0; k < 3; ++k) p.fraction[k] = {(3 - k) << 60, 0, 0};
  const Packing sorted = in_memory_order(p);
  std::vector<double> kept;
  for (const double radius : sorted.radius) kept.push_back(static_cast<float>(radius));
  EXPECT_EQ(size_classes(kept).size(), size_classes(sorted.radius).size());
}

TEST(SizeClasses, CoverAllParticlesAndAreNarrow) {
  EXPECT_TRUE(test::holds(500, [] {
    test::Dice dice(test::any_seed());
    Packing p;
    p.resize(*rc::gen::inRange<std::size_t>(1, 200));
    for (std::size_t k = 0; k < p.size(); ++k) {
      p.radius[k] = static_cast<float>(std::pow(10.0, dice.between(-1, 1)));
      p.fraction[k] = {dice.word(), dice.word(), dice.word()};
    }
    const Packing sorted = in_memory_order(p);
    const auto classes = size_classes(sorted.radius);
    RC_ASSERT(classes.front().first == 0u);
    RC_ASSERT(classes.back().last == p.size());
    for (std::size_t c = 0; c < classes.size(); ++c) {
      RC_ASSERT(classes[c].first < classes[c].last);
      RC_ASSERT(classes[c].largest_radius <= 1.5 * classes[c].smallest_radius);
      if (c > 0) {
        RC_ASSERT(classes[c].first == classes[c - 1].last);
        RC_ASSERT(classes[c].largest_radius < classes[c - 1].smallest_radius);
      }
      const auto begin = sorted.radius.begin() + static_cast<std::ptrdiff_t>(classes[c].first);
      const auto end = sorted.radius.begin() + static_cast<std::ptrdiff_t>(classes[c].last);
      RC_ASSERT(*std::min_element(begin, end) == classes[c].smallest_radius);
      RC_ASSERT(*std::max_element(begin, end) == classes[c].largest_radius);
    }
  }));
}

TEST(MemoryOrder, IsAPermutationAlongAMortonCurve) {
  EXPECT_TRUE(test::holds(200, [] {
    test::Dice dice(test::any_seed());
    Packing p;
    p.resize(*rc::gen::inRange<std::size_t>(1, 200));
    for (std::size_t k = 0; k < p.size(); ++k) {
      p.radius[k] = dice.chance(0.2) ? 5 : 0.5;
      p.fraction[k] = {test::awkward_coordinate(dice), test::awkward_coordinate(dice), dice.word()};
    }
    const auto order = memory_order(p);
    std::vector<std::uint32_t> sorted = order;
    std::sort(sorted.begin(), sorted.end());
    for (std::uint32_t k = 0; k < sorted.size(); ++k) RC_ASSERT(sorted[k] == k);
    // A Morton key is the bits of x, y, z taken in turn.
    const auto key = [&](std::uint32_t k) {
      std::uint64_t bits = 0;
      for (int b = 63; b > 63 - 21; --b)
        bits = bits << 3 | (p.fraction[k].x >> b & 1) << 2 | (p.fraction[k].y >> b & 1) << 1 |
               (p.fraction[k].z >> b & 1);
      return std::tuple(-p.radius[k], bits, k);
    };
    for (std::size_t n = 1; n < order.size(); ++n) RC_ASSERT(key(order[n - 1]) < key(order[n]));
  }));
}

}  // namespace
}  // namespace furnas
