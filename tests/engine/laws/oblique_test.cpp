#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/trials/closed_form.h"
#include "engine/trials/collision.h"
#include "tests/engine/laws/every_law.h"

namespace furnas {
namespace {

template <class Law>
class ObliqueCollision : public testing::Test {};
TYPED_TEST_SUITE(ObliqueCollision, EveryFrictionLaw, LawName);

// T6: J_t = mu times the integral of |F_n|; slip' = v_t - (7/2) J_t/m_eff for any sizes, spin_i = J_t/(0.4
// m_i R_i). The integral exceeds (1 + e) m_eff v_n because a contact that attracts while it opens rubs on.
TYPED_TEST(ObliqueCollision, GrossSlidingTakesTheImpulseOfCoulomb) {
  constexpr double speed = 1e-4;
  constexpr double friction = 0.05;
  for (double radius : {0.5, 2.5, 20.0}) {
    const double mass = reduced_mass_of(0.5, radius);
    for (const double damping : {0.5, 0.0}) {
      const HookeConstants constants{
          .normal_damping = damping, .tangential_damping = damping, .friction = friction};
      const double step = damping > 0 ? paper_step : paper_step / 4;
      const Rebound is = collide<TypeParam>(constants, step, speed, speed, 0.5, radius);
      const double impulse = friction * mass * speed * HeadOn{damping, mass}.absolute_impulse();
      const double tolerance = damping > 0 ? 1e-2 : 1e-3;
      EXPECT_NEAR((speed - is.slip) / (3.5 * impulse / mass), 1, tolerance);
      EXPECT_NEAR(is.spin_i * inertia_of(0.5) / (0.5 * impulse), 1, tolerance);
      EXPECT_NEAR(is.spin_j * inertia_of(radius) / (radius * impulse), 1, tolerance);
    }
  }
}

// T7: slip' = v_t e^(-bt) (cos Wt - (b/W) sin Wt), b = 1.75 gamma_t, W^2 = 3.5 k_t/m_eff - b^2, t the normal
// duration; without damping cos(pi sqrt 3.5) = 0.91879.
TYPED_TEST(ObliqueCollision, WithoutSlidingTheSurfacesSpringBack) {
  constexpr double speed = 1e-5;
  for (double radius : {0.5, 2.5, 20.0}) {
    const double mass = reduced_mass_of(0.5, radius);
    for (double damping : {0.0, 0.5}) {
      const HookeConstants constants{
          .normal_damping = damping, .tangential_damping = damping, .friction = no_sliding};
      const HeadOn normal{damping, mass};
      const Sticking exact = Sticking::of(damping, mass);
      const auto error = [&](double step) {
        // Legacy counts the slip of the whole step in which spheres meet: half a step too much on average.
        const double expected =
            TypeParam::synchronized
                ? exact.slip(normal.duration())
                : exact.lagged(step).slip(normal.lagged(step).duration()) +
                      step / 2 * exact.lagged(step).slip_of_displacement(normal.lagged(step).duration());
        return collide<TypeParam>(constants, step, speed, speed, 0.5, radius).slip / speed - expected;
      };
      EXPECT_LT(std::abs(error(paper_step / 2)), 1e-3) << radius << " damping " << damping;
      if (TypeParam::synchronized && damping > 0) {
        EXPECT_NEAR(std::log(error(paper_step) / error(paper_step / 4)) / std::log(4), 2, 0.1) << radius;
      }
    }
  }
}

// T9: equal spheres head-on with opposite spins do not slip: spins and the velocities across stay.
TYPED_TEST(ObliqueCollision, OppositeSpinsOfEqualSpheresStay) {
  const Vec3<double> spin{0.1, 0.3, -0.2};
  const Vec3<double> drift{0, 1e-3, 2e-3};
  const Bounce b = bounce(model_of<TypeParam>({.friction = 0.5}),
                          {.velocity = drift + Vec3<double>{-1e-2, 0, 0}, .spin = spin},
                          {.velocity = drift, .spin = -spin}, 0.3);
  ASSERT_GT(b.steps, 40);
  EXPECT_LT(norm(b.end.spin[0] - spin), 1e-13);
  EXPECT_LT(norm(b.end.spin[1] + spin), 1e-13);
  EXPECT_NEAR(b.end.velocity[0].y, drift.y, 1e-13);
  EXPECT_NEAR(b.end.velocity[1].z, drift.z, 1e-13);
}

// T11: no collision from 1 to 89 degrees makes energy.
TYPED_TEST(ObliqueCollision, NeverGainsEnergy) {
  for (double speed : {1e-3, 1e-1})
    for (double friction : {0.05, 0.3, 0.5, 1.0})
      for (double radius : {0.5, 1.5, 20.0})
        for (int degrees = 1; degrees < 90; ++degrees) {
          const double angle = degrees * std::numbers::pi / 180;
          const Ball i{.velocity = {-speed * std::cos(angle), speed * std::sin(angle), 0}};
          const Bounce b =
              bounce(model_of<TypeParam>({.friction = friction}), i, {.radius = radius}, 0.5, 1000);
          ASSERT_GT(b.steps, 0);
          ASSERT_TRUE(b.end.contacts.empty());
          const double before = 0.5 * mass_of(0.5) * speed * speed;
          EXPECT_LE(kinetic_energy(b.end), before * (1 + 1e-6))
              << degrees << " degrees, friction " << friction << ", radius " << radius;
        }
}

}  // namespace
}  // namespace furnas
