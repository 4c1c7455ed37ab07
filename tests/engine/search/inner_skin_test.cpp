#include "engine/search/inner_skin.h"

#include <gtest/gtest.h>

#include "tests/engine/support/hot_gas.h"
#include "tests/engine/support/same_packing.h"

namespace furnas {
namespace {

PairList list_of(const Skin& skin, std::size_t rows = 0) {
  PairList list;
  list.classes = {{.first = 0, .last = 1000, .smallest_radius = 0.5, .largest_radius = 0.5}};
  list.skin = skin;
  list.partner.resize(rows);
  return list;
}

// A skin s lasts s/motion steps, and the rows within it are s/wide of the list's: s = sqrt(wide motion)
// makes 1/life + s/wide least.
TEST(InnerList, LastAsLongAsIsCheapest) {
  const double wide = 0.1, motion = 1e-4, strain = 1e-5;
  InnerList inner;
  choose_inner_skin(list_of({wide, wide}), motion, strain, inner);
  EXPECT_TRUE(inner.kept);
  const double margin = std::sqrt(1.2);
  EXPECT_NEAR(inner.skin.fixed, margin * std::sqrt(wide * motion), 1e-15);
  EXPECT_NEAR(inner.skin.relative, margin * 1e-3, 1e-15);
}

TEST(InnerList, AreNotKeptUnderAListThatSoonWearsOut) {
  InnerList inner;
  choose_inner_skin(list_of({0.1, 0}), 0.01, 0, inner);
  EXPECT_FALSE(inner.kept);
  choose_inner_skin(list_of({0, 0}), 0, 0, inner);
  EXPECT_FALSE(inner.kept) << "a list without room";
}

TEST(InnerList, KeepSomeRoomWhenNothingMoves) {
  InnerList inner;
  choose_inner_skin(list_of({0.1, 0.01}), 0, 0, inner);
  EXPECT_TRUE(inner.kept);
  EXPECT_DOUBLE_EQ(inner.skin.fixed, 1e-3);
  EXPECT_DOUBLE_EQ(inner.skin.relative, 1e-4);
}

TEST(InnerList, AreGivenUpWhereMostRowsAreNear) {
  const PairList list = list_of({0.1, 0}, 100);
  InnerList inner;
  inner.kept = true;
  inner.rows.resize(100);
  inner.count = {20, 40};
  drop_inner_list_if_needless(list, inner);
  EXPECT_TRUE(inner.kept);
  EXPECT_EQ(inner_rows(list, inner), 60u);
  inner.count = {21, 40};
  drop_inner_list_if_needless(list, inner);
  EXPECT_FALSE(inner.kept);
  EXPECT_EQ(inner_rows(list, inner), 100u);
  EXPECT_TRUE(inner.rows.empty());
}

// A simulation that has just been loaded looks at all rows: step by step it must agree with one that looks at
// inner list alone, in hot gases under violent strain.
TEST(InnerList, ChangeNoBit) {
  std::int64_t steps = 0;
  std::int64_t with_fewer = 0;
  EXPECT_TRUE(test::holds(60, [&] {
    test::Dice dice(test::any_seed());
    auto [start, model] = test::hot_gas(dice, 0.5);
    model.precision = dice.chance(0.5) ? Precision::mixed : Precision::full;
    model.skin = dice.between(0, 2);
    const auto simulation = make_simulation(model, start);
    const auto fresh = make_simulation(model, start);
    for (int step = 0; step < 150 && simulation->cell().volume() > 0.3 * start.cell.volume(); ++step) {
      fresh->load(simulation->packing());
      fresh->advance(1);
      simulation->advance(1);
      RC_ASSERT(test::same_packing(simulation->packing(), fresh->packing()));
      ++steps;
      with_fewer += simulation->neighbours().inner_pairs < simulation->neighbours().pairs;
    }
  }));
  EXPECT_GT(with_fewer, steps / 4);
  EXPECT_LT(with_fewer, steps);
}

TEST(InnerList, AreFewInAGas) {
  Model slow = test::hasty_model(0.3);
  slow.barostat.pressure = 1e-4;
  const auto simulation = make_simulation(slow, test::hasty_gas());
  simulation->advance(100);
  EXPECT_LT(simulation->neighbours().inner_pairs, simulation->neighbours().pairs / 2);
}

}  // namespace
}  // namespace furnas
