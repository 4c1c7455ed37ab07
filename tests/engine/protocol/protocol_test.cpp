#include "engine/protocol/protocol.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <variant>

#include "engine/base/require.h"
#include "engine/base/sphere.h"
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
  const AnyLaw usual = law_of({});
  EXPECT_TRUE(std::holds_alternative<HookeSynchronized>(usual));
  EXPECT_EQ(backbone_threshold(usual), 2);
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
  EXPECT_NEAR(*time_step_of({}), 0.02 * unit, 1e-15);
  EXPECT_NEAR(*time_step_of({}), 0.032415, 1e-6) << "the step of the study";
  EXPECT_NEAR(*time_step_of({.time_step = 0.05}), 0.05 * unit, 1e-15);
  EXPECT_EQ(*time_step_of({.time_step_absolute = 0.03}), 0.03);
  const Protocol overdamped{.contact = {.normal_damping = 4}};
  EXPECT_FALSE(time_step_of(overdamped));
  EXPECT_THROW(model_of(overdamped, dilute_start({.large = 2})), InputError);
}

}  // namespace
}  // namespace furnas
