#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/trials/row_of_two.h"
#include "tests/engine/laws/every_law.h"
#include "tests/engine/support/setups.h"

namespace furnas {
namespace {

template <class Law>
class EnduringContact : public testing::Test {};
TYPED_TEST_SUITE(EnduringContact, EveryLaw, LawName);

// T5: u'' + 2 gamma u' + (2 k/m_eff) u = 0, so with w^2 = 2k/m_eff, g = 2 gamma and the velocity v that
// damping sees x_{n+1} = 2 x_n - x_{n-1} - dt^2 (w^2 x_n + g v): v = (x_n - x_{n-1})/dt when it lags, which
// is x_{n+1} = (2 - g dt - w^2 dt^2) x_n - (1 - g dt) x_{n-1}; predicted for the full step it gains a dt/2.
TYPED_TEST(EnduringContact, ThroughBothImagesFollowsItsRecurrence) {
  const double amplitude = 1e-2;
  const double dt = paper_step;
  const double g = 2 * HookeConstants{}.normal_damping;
  const auto simulation = make_simulation(model_of<TypeParam>({}), RowOfTwo::start(amplitude, {}));
  double before = RowOfTwo::shift_of(simulation->packing());
  simulation->advance(1);
  double now = RowOfTwo::shift_of(simulation->packing());
  double acceleration = -2 / RowOfTwo::reduced_mass() * before;
  for (int step = 1; step < 2000; ++step) {
    const double v = (now - before) / dt + (TypeParam::synchronized ? acceleration * dt / 2 : 0);
    acceleration = -2 / RowOfTwo::reduced_mass() * now - g * v;
    const double next = 2 * now - before + dt * dt * acceleration;
    simulation->advance(1);
    before = now;
    now = RowOfTwo::shift_of(simulation->packing());
    ASSERT_NEAR(now, next, 1e-12 * amplitude) << step;
  }
  EXPECT_EQ(simulation->packing().contacts.size(), 2u);
}

// T5: u = u_0 e^(-gamma t) (cos Wt + (gamma/W) sin Wt), W^2 = 2k/m_eff - gamma^2; order 2, or 1 when damping
// lags.
TYPED_TEST(EnduringContact, DampedOscillationConvergesToTheClosedForm) {
  const double amplitude = 1e-2;
  const double gamma = HookeConstants{}.normal_damping;
  const double time = 256 * paper_step;
  const auto error = [&](int divisions) {
    const double dt = paper_step / divisions;
    const auto simulation = make_simulation(model_of<TypeParam>({}, dt), RowOfTwo::start(amplitude, {}));
    double worst = 0;
    for (int n = 1; n <= 16; ++n) {
      const double t = time * n / 16;
      simulation->advance(16 * divisions);
      const double exact = RowOfTwo::shift_at(t, gamma);
      worst = std::max(worst, std::abs(RowOfTwo::shift_of(simulation->packing()) / amplitude - exact));
    }
    return worst;
  };
  EXPECT_NEAR(std::log2(error(2) / error(4)), TypeParam::synchronized ? 2 : 1, 0.1);
}

template <class Law>
class Gear : public testing::Test {};
TYPED_TEST_SUITE(Gear, EveryFrictionLaw, LawName);

constexpr double gear_friction = 0.3;
constexpr double first_spin = 0.5;

template <class Law>
double lever_arm() {
  return Law::synchronized ? RowOfTwo::radius - RowOfTwo::squeeze / 2 : RowOfTwo::radius;
}

// T10: while both contacts slide d omega/dt = -2 mu F_n a/I for both spheres, so B turns against A; the net
// force is 0.
TYPED_TEST(Gear, SlidingTurnsBothSpheresAlike) {
  const double slowing =
      2 * gear_friction * RowOfTwo::squeeze * lever_arm<TypeParam>() / inertia_of(RowOfTwo::radius);
  const double sticks_at = first_spin / (2 * slowing);
  const auto simulation = make_simulation(model_of<TypeParam>({.friction = gear_friction}),
                                          RowOfTwo::start(0, {0, 0, first_spin}));
  simulation->advance(1);
  Packing before = simulation->packing();
  ASSERT_GT(sticks_at, 40 * paper_step);
  while (before.time < 0.9 * sticks_at) {
    simulation->advance(1);
    const Packing now = simulation->packing();
    for (std::size_t k = 0; k < 2; ++k) {
      ASSERT_NEAR(now.spin[k].z - before.spin[k].z, -slowing * paper_step, 1e-10);
      ASSERT_LT(norm(now.force[k]), 1e-15);
    }
    before = now;
  }
}

// T10: the two contacts are one pair with two histories, which are opposite.
TYPED_TEST(Gear, EachContactHasItsOwnHistory) {
  const Packing p = after(model_of<TypeParam>({.tangential_damping = 0, .friction = gear_friction}),
                          RowOfTwo::start(0, {0, 0, first_spin}), 20);
  ASSERT_EQ(p.contacts.size(), 2u);
  EXPECT_NE(p.contacts[0].image, p.contacts[1].image);
  EXPECT_NEAR(norm(p.contacts[0].history), gear_friction * RowOfTwo::squeeze, 1e-15);
  EXPECT_LT(norm(p.contacts[0].history + p.contacts[1].history), 1e-15);
}

// T10: slip ends at t_s = omega_0 I/(4 mu F_n a).
TYPED_TEST(Gear, SticksOnTime) {
  const double slowing =
      2 * gear_friction * RowOfTwo::squeeze * lever_arm<TypeParam>() / inertia_of(RowOfTwo::radius);
  const auto simulation =
      make_simulation(model_of<TypeParam>({.tangential_damping = 0, .friction = gear_friction}),
                      RowOfTwo::start(0, {0, 0, first_spin}));
  const auto slip = [&] { return simulation->packing().spin[0].z + simulation->packing().spin[1].z; };
  simulation->advance(1);
  // Friction needs a slip behind it: it starts at the end of the first step, for the half step before.
  const double late = paper_step / 2;
  double before = first_spin;
  while (slip() > 0 && simulation->step() < 1000) {
    before = slip();
    simulation->advance(1);
  }
  const double last = simulation->packing().time - paper_step;
  const double sticks_at = last + paper_step * before / (before - slip());
  EXPECT_NEAR(sticks_at / (late + first_spin / (2 * slowing)), 1, 1e-3);
}

// T10: then the gear runs on: omega_A = omega_0/2 = -omega_B, without force.
TYPED_TEST(Gear, KeepsHalfTheSpin) {
  const Packing p =
      after(model_of<TypeParam>({.friction = gear_friction}), RowOfTwo::start(0, {0, 0, first_spin}), 2000);
  EXPECT_NEAR(p.spin[0].z, first_spin / 2, 1e-3 * first_spin);
  EXPECT_NEAR(p.spin[1].z, -first_spin / 2, 1e-3 * first_spin);
  EXPECT_LT(norm(p.force[0]) + norm(p.force[1]), 1e-15);
}

}  // namespace
}  // namespace furnas
