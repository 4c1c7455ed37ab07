#include "engine/protocol/protocol.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>

#include "engine/base/require.h"
#include "engine/base/sphere.h"
#include "engine/monitor/stability.h"
#include "engine/start/mixture.h"

namespace furnas {
namespace {

// W = beta M L^2/12 with L the edge of a cube that the spheres fill to 0.64; their density is 1.
TEST(Protocol, TheBathIsAsHeavyAsThePacking) {
  const Packing packing = dilute_start({.large = 64});
  const double mass = 64 * sphere_volume(0.5), unit = mass * std::pow(mass / 0.64, 2.0 / 3) / 12;
  EXPECT_NEAR(model_of({}, packing).barostat.inertia, unit, 1e-12 * unit);
  EXPECT_NEAR(model_of({.inertia = 2.5}, packing).barostat.inertia, 2.5 * unit, 1e-12 * unit);
  EXPECT_EQ(model_of({.inertia_absolute = 7}, packing).barostat.inertia, 7);
}

TEST(Protocol, TheLawFollowsFromNameAndFriction) {
  const AnyLaw default_law = law_of({});
  EXPECT_TRUE(std::holds_alternative<HookeSynchronized>(default_law));
  EXPECT_EQ(backbone_threshold(default_law), 2);
  EXPECT_TRUE(std::holds_alternative<HookeHistory>(law_of({.law = "hooke_history"})));
  const AnyLaw smooth = law_of({.contact = {.friction = 0}});
  EXPECT_TRUE(std::holds_alternative<Frictionless<false>>(smooth));
  EXPECT_EQ(backbone_threshold(smooth), 4);
  EXPECT_TRUE(std::holds_alternative<Frictionless<true>>(
      law_of({.law = "hooke_history", .contact = {.friction = 0}})));
  EXPECT_THROW(law_of({.law = "hertz"}), InputError);
}

TEST(Protocol, OnlyTheLegacyLawMovesTheCellAsLammpsDoes) {
  const Packing packing = dilute_start({.large = 2});
  EXPECT_FALSE(model_of({}, packing).barostat.legacy);
  EXPECT_TRUE(model_of({.law = "hooke_history"}, packing).barostat.legacy);
  EXPECT_FALSE(model_of({.contact = {.friction = 0}}, packing).barostat.legacy);
}

// t_c = pi (2 k_n/m_s - gamma_n^2/4)^(-1/2) of two spheres of size d_s, of mass pi/6.
TEST(Protocol, TheStepIsCountedInCollisionTimes) {
  const double unit = std::numbers::pi / std::sqrt(12 / std::numbers::pi - 0.25 / 4);
  EXPECT_NEAR(time_step_of({.time_step = 0.02}), 0.032415, 1e-6) << "the time step of the paper";
  EXPECT_NEAR(time_step_of({.time_step = 0.05}), 0.05 * unit, 1e-15);
  EXPECT_EQ(time_step_of({.time_step_absolute = 0.03}), 0.03);
  // Overdamped spheres do not collide in any time; that of the undamped pair counts instead.
  EXPECT_NEAR(time_unit_of({.contact = {.normal_damping = 4}}),
              std::sqrt(std::numbers::pi / 12) * std::numbers::pi, 1e-12);
}

TEST(Protocol, TheStepIsChosenByFrictionAndTheStiffestPair) {
  EXPECT_NEAR(time_step_of({}) / time_unit_of({}), 0.0633, 1e-4) << "the rule of eight contacts";
  EXPECT_NEAR(time_step_of({.contact = {.tangential_damping = 0.1, .friction = 0.3}}),
              0.08 * time_unit_of({}), 1e-15);
  EXPECT_NEAR(time_step_of({.contact = {.friction = 0}}), 0.1 * time_unit_of({}), 1e-15);
  const Protocol stiff{.contact = {.tangential_stiffness = 10, .friction = 0.3}};
  EXPECT_NEAR(time_step_of(stiff), largest_stable_step_of_midway(law_of(stiff), equal_pair(1), 8), 1e-15);
  const Protocol syrup{.contact = {.normal_damping = 50, .friction = 0}};
  EXPECT_NEAR(time_step_of(syrup), largest_stable_step_of_midway(law_of(syrup), equal_pair(1), 8), 1e-15);
  EXPECT_LT(time_step_of(syrup), largest_stable_step(law_of(syrup), equal_pair(1), 4))
      << "stable for four contacts";
  EXPECT_EQ(chosen_time_step(syrup).rule, "auto: the rule for a small sphere that touches eight others");
  EXPECT_EQ(chosen_time_step({.time_step = 0.02}).rule, "compaction.time_step");
  EXPECT_EQ(
      chosen_time_step({.contact = {.normal_damping = 50, .tangential_damping = 0, .friction = 0.3}}).rule,
      "auto: the rule for a small sphere that sticks to eight others");
  // Eight times the mass at twice the size: two large spheres alone swing 8^(1/2) times as slowly.
  const Protocol undamped{.contact = {.normal_damping = 0, .friction = 0}};
  Packing large = dilute_start({.large = 2});
  std::fill(large.radius.begin(), large.radius.end(), 1.0);
  EXPECT_NEAR(model_of(undamped, large).time_step, std::sqrt(8) * time_step_of(undamped), 1e-12)
      << "by what is there";
}

// c in units of (p_a V/W)^(1/2): twice the pressure, 2^(1/2) times the drag; V is that of the spheres over
// 0.64.
TEST(Protocol, TheDragOfTheCellIsInUnitsOfItsOwnRate) {
  const Packing packing = dilute_start({.large = 64});
  const auto baths = baths_of({.pressures = {1e-4, 2e-4}, .cell_damping = 3}, packing);
  ASSERT_EQ(baths.size(), 2u);
  const double rate = std::sqrt(1e-4 * packing.sphere_volume() / 0.64 / baths[0].inertia);
  EXPECT_NEAR(baths[0].drag, 3 * rate, 1e-12 * rate);
  EXPECT_NEAR(baths[1].drag, std::sqrt(2) * baths[0].drag, 1e-12 * rate);
  EXPECT_EQ(baths[1].pressure, 2e-4);
  EXPECT_EQ(baths_of({.cell_damping = 3, .drag = 0.7}, packing).front().drag, 0.7);
}

TEST(Protocol, NumbersThatHaveNoMeaningAreRefused) {
  const Packing packing = dilute_start({.large = 64});
  const double no_number = std::nan("");
  const Protocol wrong[] = {{.pressures = {}},
                            {.pressures = {1e-4, 0}},
                            {.pressures = {-1e-4}},
                            {.pressures = {no_number}},
                            {.inertia = 0},
                            {.inertia_absolute = -1},
                            {.cell_damping = -1},
                            {.drag = no_number},
                            {.time_step = 0},
                            {.time_step_absolute = no_number},
                            {.contact = {.friction = -0.1}},
                            {.contact = {.normal_damping = no_number}},
                            {.rest = {.window = 0}},
                            {.skin = -0.1}};
  for (const Protocol& protocol : wrong) {
    EXPECT_THROW(baths_of(protocol, packing), InputError) << &protocol - wrong;
    EXPECT_THROW(model_of(protocol, packing), InputError) << &protocol - wrong;
  }
}

}  // namespace
}  // namespace furnas
