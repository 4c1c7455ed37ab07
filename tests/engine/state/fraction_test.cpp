#include "engine/state/fraction.h"

#include <gtest/gtest.h>

#include "tests/engine/support/property.h"
#include "tests/engine/support/random_packing.h"

namespace furnas {
namespace {

constexpr std::uint64_t half = std::uint64_t{1} << 63;

TEST(Fraction, IsFixedPointModuloOne) {
  EXPECT_EQ(to_fixed(0.0), 0u);
  EXPECT_EQ(to_fixed(0.25), half / 2);
  EXPECT_EQ(to_fixed(0.5), half);
  EXPECT_EQ(to_fixed(-0.5), half);
  EXPECT_EQ(to_fixed(-0.25), half + half / 2);
  EXPECT_EQ(to_fixed(1.0), 0u);
  EXPECT_EQ(to_fixed(-3.0), 0u);
  EXPECT_EQ(to_fixed(1e15 + 0.5), half);
  EXPECT_EQ(to_fixed(0x1p-64), 1u);
  EXPECT_EQ(to_fixed(-0x1p-64), ~std::uint64_t{0});
  EXPECT_EQ(to_fixed(std::nextafter(0.5, 0.0)), half - 1024);
  EXPECT_EQ(to_fixed(-1e-300), 0u);
}

TEST(Fraction, WrapsThroughAFace) {
  const std::uint64_t before = ~std::uint64_t{0};
  EXPECT_EQ(before + to_fixed(0x1p-64), 0u);
  EXPECT_EQ(std::uint64_t{0} + to_fixed(-0x1p-64), before);
  // No place is ever "just outside": the number nearest to the last one rounds up to 1, no further.
  EXPECT_EQ(in_unit_cell({before, 0, half}), (Vec3<double>{1, 0, 0.5}));
}

TEST(Fraction, GoesThroughDoublesAndBack) {
  EXPECT_TRUE(test::holds(2000, [] {
    test::Dice dice(test::any_seed());
    const double s = dice.chance(0.2) ? dice.between(0, 1e-12) : dice.between(0, 1);
    const double cells = static_cast<double>(dice.below(5)) - 2;
    const Fraction f = to_fraction({s, s, s});
    RC_ASSERT(std::abs(in_unit_cell(f).x - s) <= 0x1p-64);
    const double moved = s + cells;  // rounds: what matters is the double itself
    const double whole = std::floor(moved);
    RC_ASSERT(std::abs(in_unit_cell(to_fraction({moved, 0, 0})).x - (moved - whole)) <= 0x1p-53);
  }));
}

TEST(Fraction, NearestDifferenceIsExactAndOdd) {
  EXPECT_TRUE(test::holds(2000, [] {
    test::Dice dice(test::any_seed());
    const Fraction i{test::awkward_coordinate(dice), test::awkward_coordinate(dice), dice.word()};
    const Fraction j{test::awkward_coordinate(dice), test::awkward_coordinate(dice), dice.word()};
    const Vec3<double> d = nearest_difference(i, j);
    const Vec3<double> back = nearest_difference(j, i);
    for (const auto& [there, opposite] : {std::pair{d.x, back.x}, {d.y, back.y}, {d.z, back.z}}) {
      RC_ASSERT(there >= -0.5 && there <= 0.5);
      if (there != -0.5) RC_ASSERT(opposite == -there);
    }
    RC_ASSERT(j.x + to_fixed(d.x) - i.x + 1024 <= 2048u);  // the double holds 53 of the 64 bits
  }));
}

TEST(Fraction, CountsTheCellsCrossed) {
  const auto cells = [](std::uint64_t a, std::uint64_t b) {
    return crossed({5, 0, 0}, {a, 0, 0}, {b, 0, 0})[0];
  };
  const std::uint64_t last = ~std::uint64_t{0};
  EXPECT_EQ(cells(7, 7), 5);
  EXPECT_EQ(cells(last, 0), 6);
  EXPECT_EQ(cells(0, last), 4);
  EXPECT_EQ(cells(last, half - 2), 6);
  EXPECT_EQ(cells(half, 1), 5);      // back by almost half a cell
  EXPECT_EQ(cells(half + 2, 1), 6);  // forward by almost half a cell
  EXPECT_EQ(cells(half - 1, half + 1), 5);
}

TEST(Fraction, CrossedFollowsAnyWay) {
  EXPECT_TRUE(test::holds(500, [] {
    test::Dice dice(test::any_seed());
    Fraction s{test::awkward_coordinate(dice), test::awkward_coordinate(dice),
               test::awkward_coordinate(dice)};
    const Fraction start = s;
    Image image{};
    Vec3<double> displacement;
    for (int step = 0; step < 20; ++step) {
      const Vec3<double> move = dice.vector(0.49);
      const Fraction m = to_fraction(move);
      const Fraction next{s.x + m.x, s.y + m.y, s.z + m.z};
      image = crossed(image, s, next);
      s = next;
      displacement += move;
    }
    const Vec3<double> a = in_unit_cell(start);
    const Vec3<double> b = in_unit_cell(s);
    RC_ASSERT(std::abs(b.x + image[0] - a.x - displacement.x) < 1e-14);
    RC_ASSERT(std::abs(b.y + image[1] - a.y - displacement.y) < 1e-14);
    RC_ASSERT(std::abs(b.z + image[2] - a.z - displacement.z) < 1e-14);
  }));
}

}  // namespace
}  // namespace furnas
