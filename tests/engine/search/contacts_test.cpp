#include <gtest/gtest.h>

#include "tests/engine/support/brute_force_comparison.h"
#include "tests/engine/support/property.h"
#include "tests/engine/support/random_packing.h"

namespace furnas {
namespace {

using test::Dice;

Model random_model(Dice& dice) {
  Model model;
  HookeConstants constants;
  constants.friction = dice.chance(0.3) ? 0 : dice.between(0, 1);
  if (constants.friction == 0)
    model.law = Frictionless<false>{constants};
  else
    model.law = HookeSynchronized{constants};
  if (dice.chance(0.8)) model.skin = dice.chance(0.3) ? 0 : dice.between(0, 0.5);
  return model;
}

TEST(Contacts, EqualBruteForceInAnyCell) {
  EXPECT_TRUE(test::holds(3000, [] {
    Dice dice(test::any_seed());
    test::RandomPacking wanted;
    wanted.size_ratio = *rc::gen::element(1, 2, 3, 10, 40);
    wanted.large = *rc::gen::inRange<std::size_t>(0, 4);
    wanted.small = *rc::gen::inRange<std::size_t>(1, 40);
    wanted.cell = (wanted.large > 0 ? wanted.size_ratio : 1) * dice.between(2.5, 5);
    wanted.spread = dice.chance(0.5) ? 0 : 0.6;
    test::compare_with_brute_force(random_model(dice), test::random_packing(dice, wanted));
  }));
}

// Smaller than two reaches: a pair meets several times, a sphere meets its own images.
TEST(Contacts, EqualBruteForceInCellsSmallerThanASphere) {
  EXPECT_TRUE(test::holds(3000, [] {
    Dice dice(test::any_seed());
    test::RandomPacking wanted;
    wanted.size_ratio = *rc::gen::element(1, 2, 5, 40);
    wanted.large = *rc::gen::inRange<std::size_t>(0, 3);
    wanted.small = *rc::gen::inRange<std::size_t>(0, 6);
    if (wanted.large + wanted.small == 0) wanted.large = 1;
    wanted.cell = (wanted.large > 0 ? wanted.size_ratio : 1) * dice.between(0.35, 2.5);
    test::compare_with_brute_force(random_model(dice), test::random_packing(dice, wanted));
  }));
}

// Crystals: centres exactly on faces, edges and halves of the cell, spheres that just touch or just not.
TEST(Contacts, EqualBruteForceInCrystals) {
  for (int cells : {1, 2, 3, 5})
    for (double spacing : {1.0, 1 - 0x1p-53, 1 - 0x1p-40, 1 + 0x1p-40, 0.75, 0.5})
      for (std::uint64_t shift : {0ull, 1ull, ~0ull, 1ull << 63, 12345678901234567ull}) {
        Packing p;
        p.cell.edges = {spacing * cells, spacing * cells, spacing * cells};
        for (int x = 0; x < cells; ++x)
          for (int y = 0; y < cells; ++y)
            for (int z = 0; z < cells; ++z) {
              const auto at = [&](int n) { return to_fixed(static_cast<double>(n) / cells) + shift; };
              p.fraction.push_back({at(x), at(y), at(z)});
            }
        const auto fraction = p.fraction;
        p.resize(fraction.size());
        p.radius.assign(p.size(), 0.5);
        p.mass.assign(p.size(), 1);
        for (double skin : {0.0, 0.1}) {
          Model model;
          model.law = Frictionless<false>{};
          model.skin = skin;
          EXPECT_TRUE(test::holds(1, [&] { test::compare_with_brute_force(model, p); }))
              << cells << " cells, spacing " << spacing << ", shift " << shift << ", skin " << skin;
        }
      }
}

}  // namespace
}  // namespace furnas
