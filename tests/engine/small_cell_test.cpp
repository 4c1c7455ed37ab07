#include <gtest/gtest.h>

#include "tests/engine/support/compaction.h"
#include "tests/engine/support/property.h"
#include "tests/engine/support/random_packing.h"
#include "tests/engine/support/same_packing.h"

namespace furnas {
namespace {

constexpr std::int64_t steps = 400;

/// A few spheres in a cell so small that pairs meet more than once and spheres meet themselves.
Packing crowded(test::Dice& dice) {
  test::RandomPacking wanted;
  wanted.size_ratio = dice.between(1, 3);
  wanted.large = 1 + dice.below(2);
  wanted.small = dice.below(6);
  wanted.cell = wanted.size_ratio * dice.between(0.8, 2.2);
  wanted.speed = 0.02;
  return test::random_packing(dice, wanted);
}

Model crowded_model(test::Dice& dice) {
  Model model = test::hasty_model(0.3);
  model.barostat.inertia = 100;
  model.barostat.pressure = dice.between(0, 0.05);
  model.barostat.drag = 0.05;
  return model;
}

Packing end_of_run(const Model& model, const Packing& start, std::optional<double> skin) {
  Model with_skin = model;
  with_skin.skin = skin;
  const auto simulation = make_simulation(with_skin, start);
  simulation->advance(steps);
  return simulation->packing();
}

// The skin decides whether a list needs images and which rows it has; no bit of the motion may follow.
TEST(SmallCell, TheSameBitsForAnySkin) {
  EXPECT_TRUE(test::holds(150, [] {
    test::Dice dice(test::any_seed());
    const Packing start = crowded(dice);
    const Model model = crowded_model(dice);
    const Packing expected = end_of_run(model, start, {});
    for (double skin : {0.0, 0.01, 0.1, 0.5}) {
      const auto same = test::same_state(end_of_run(model, start, skin), expected);
      if (!same) RC_FAIL(std::string(same.message()) + ", skin " + std::to_string(skin));
    }
  }));
}

TEST(SmallCell, TheSameBitsWhenThePackingIsTakenOutAndPutBack) {
  EXPECT_TRUE(test::holds(100, [] {
    test::Dice dice(test::any_seed());
    const Packing start = crowded(dice);
    const Model model = crowded_model(dice);
    const Packing expected = end_of_run(model, start, {});
    const auto simulation = make_simulation(model, start);
    while (simulation->step() < steps) {
      simulation->advance(
          std::min<std::int64_t>(1 + static_cast<std::int64_t>(dice.below(3)), steps - simulation->step()));
      simulation->load(simulation->packing());
    }
    const auto same = test::same_packing(simulation->packing(), expected);
    if (!same) RC_FAIL(same.message());
  }));
}

// A skin as wide as the cell must not let a particle pass half a cell unseen.
TEST(SmallCell, CountsTheCellsCrossedUnderAWideSkin) {
  EXPECT_TRUE(test::holds(40, [] {
    test::Dice dice(test::any_seed());
    Packing start = crowded(dice);
    for (Vec3<double>& v : start.velocity) v += dice.vector(1);
    Model model = crowded_model(dice);
    const Packing expected = end_of_run(model, start, 0.0);
    for (double skin : {1.0, 5.0}) {
      const auto same = test::same_state(end_of_run(model, start, skin), expected);
      if (!same) RC_FAIL(std::string(same.message()) + ", skin " + std::to_string(skin));
    }
  }));
}

}  // namespace
}  // namespace furnas
