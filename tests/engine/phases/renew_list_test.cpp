#include "engine/phases/renew_list.h"

#include <gtest/gtest.h>

#include "engine/trials/crystal.h"
#include "tests/engine/support/brute_force.h"
#include "tests/engine/support/hot_gas.h"

namespace furnas {
namespace {

/// Contacts of the packing now that the list does not know, or knows and should not.
std::size_t wrong_contacts(const Packing& p) {
  auto expected = test::brute_pairs(p, 0);
  std::size_t wrong = 0;
  for (const Contact& c : p.contacts) {
    const bool known = expected.erase(test::name_of(p, c)) == 1;
    wrong += !known && c.overlap > 1e-13 * (p.radius[c.i] + p.radius[c.j]);
  }
  for (const auto& [name, touch] : expected)
    wrong += p.radius[name.i] + p.radius[name.j] - touch.distance > 1e-13L * touch.distance;
  return wrong;
}

// The whole chain of watching, measuring and building, in hot gases under violent strain.
TEST(RenewList, HasEveryContactInEveryStep) {
  EXPECT_TRUE(test::holds(60, [] {
    test::Dice dice(test::any_seed());
    auto [start, model] = test::hot_gas(dice, 1);
    if (dice.chance(0.5)) model.skin = dice.between(0, 1);
    const auto simulation = make_simulation(model, start);
    for (int step = 0; step < 150 && simulation->cell().volume() > 0.3 * start.cell.volume(); ++step) {
      simulation->advance(1);
      RC_ASSERT(wrong_contacts(simulation->packing()) == 0u);
    }
  }));
}

TEST(RenewList, RebuildsRarelyWhenLittleMoves) {
  const auto simulation = make_simulation(test::hasty_model(0), test::hasty_gas());
  simulation->advance(700);
  EXPECT_LT(simulation->neighbours().builds, 100);
}

// A packing that has come to rest does not keep the pairs that its motion has asked for.
TEST(RenewList, ShedsNeedlessPairsWhenNothingMoves) {
  constexpr double gap = 0.03;  // of neighbours; the first list reaches further
  Model model = test::hasty_model(0);
  model.barostat.freedom = CellFreedom::fixed;
  const Packing still = simple_cubic(1 + gap, 4);
  const auto simulation = make_simulation(model, still);
  simulation->advance(128);
  EXPECT_EQ(simulation->neighbours().pairs, 3 * still.size()) << "too young to be asked";
  simulation->advance(1);
  EXPECT_EQ(simulation->neighbours().pairs, 0u);
  simulation->advance(4000);
  EXPECT_EQ(simulation->neighbours().builds, 2) << "asked again, and found narrow enough";

  model.skin = 0.05;
  const auto fixed = make_simulation(model, still);
  fixed->advance(1000);
  EXPECT_EQ(fixed->neighbours().builds, 1) << "whoever gives a skin gets it";
}

}  // namespace
}  // namespace furnas
