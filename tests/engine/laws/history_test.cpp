#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "engine/trials/driven.h"
#include "tests/engine/laws/every_law.h"
#include "tests/engine/support/setups.h"

namespace furnas {
namespace {

using V = Vec3<double>;

template <class Law>
class History : public testing::Test {};
TYPED_TEST_SUITE(History, EveryFrictionLaw, LawName);

constexpr double time_step = 0.01;

/// Two small spheres at rest that overlap along x.
Touch<double> touch_at_rest(double overlap) {
  Touch<double> t{};
  t.distance = 1 - overlap;
  t.branch = {t.distance, 0, 0};
  t.overlap = overlap;
  t.radius_i = t.radius_j = 0.5;
  t.reduced_mass = reduced_mass_of(0.5, 0.5);
  t.time_step = time_step;
  return t;
}

/// A step in which the pair turns rigidly about z by `angle`, as step n of that turn: no surface slips. A
/// rigid turn in finite steps has the spin 2 tan(angle/2)/dt against the chord seen in the middle of the
/// step, and sin(angle)/dt against the chord seen with the normal of its end.
Touch<double> rigid_turn(bool synchronized, double angle, int n) {
  const double overlap = synchronized ? 0.01 : 0;
  Touch<double> t = touch_at_rest(overlap);
  const auto branch = [&](double a) { return V{t.distance * std::cos(a), t.distance * std::sin(a), 0}; };
  t.branch = branch(n * angle);
  t.drift = (t.branch - branch((n - 1) * angle)) * (1 / time_step);
  t.midway.velocity = t.drift;
  const double spin = (synchronized ? 2 * std::tan(angle / 2) : std::sin(angle)) / time_step;
  t.midway.spin_i = t.midway.spin_j = {0, 0, spin};
  return t;
}

// T13: ten rigid turns about an axis across the normal: the history turns with the pair and keeps its length.
// Projection alone (legacy) multiplies its part in the plane of the turn with cos(angle) each step.
TYPED_TEST(History, TurnsWithThePair) {
  const TypeParam law{{.tangential_damping = 0, .friction = no_sliding}};
  constexpr int turns = 10;
  for (int steps_a_turn : {63, 628}) {
    const double angle = 2 * std::numbers::pi / steps_a_turn;
    V xi{0, 3e-3, 4e-3};
    for (int n = 1; n <= turns * steps_a_turn; ++n) law(rigid_turn(TypeParam::synchronized, angle, n), xi);
    const double kept = TypeParam::synchronized ? 1 : std::pow(std::cos(angle), turns * steps_a_turn);
    EXPECT_LT(norm(xi - V{0, 3e-3 * kept, 4e-3}), 1e-10 * 5e-3) << steps_a_turn;
  }
}

// T14: both spheres spin about the normal: the history turns by the integral of n (w_i + w_j)/2 and keeps its
// length; with the angle d of a step the law turns by 2 atan(d/2), exact to second order. Legacy does not
// turn it.
TYPED_TEST(History, TwistsWithThePair) {
  const TypeParam law{{.tangential_damping = 0, .friction = no_sliding}};
  for (double angle : {0.1, 0.01}) {
    constexpr int steps = 1000;
    Touch<double> t = touch_at_rest(0.01);
    t.midway.spin_i = {1.5 * angle / time_step, 0, 0};
    t.midway.spin_j = {0.5 * angle / time_step, 0, 0};
    V xi{0, 1e-3, 0};
    for (int n = 0; n < steps; ++n) law(t, xi);
    const double turned = TypeParam::synchronized ? steps * 2 * std::atan(angle / 2) : 0;
    EXPECT_LT(norm(xi - V{0, 1e-3 * std::cos(turned), 1e-3 * std::sin(turned)}), 1e-10 * 1e-3);
    EXPECT_NEAR(2 * std::atan(angle / 2), angle, angle * angle * angle / 11.9);
  }
}

/// Two small spheres that nothing can stop, overlapping along x, with the history xi of the second against
/// the first.
Packing unstoppable_pair(double distance, const V& spin, const V& xi) {
  Packing p = packing_of(cube(16), {{.position = {8 - distance / 2, 8, 8}, .spin = spin},
                                    {.position = {8 + distance / 2, 8, 8}, .spin = spin}});
  p.mass.assign(2, 1e30);
  Contact c;
  c.i = 1;
  c.j = 0;
  c.history = xi;
  p.contacts = {c};
  return p;
}

// T13 through the engine: the pair circles its middle ten times, and the history with it.
TYPED_TEST(History, TurnsWithACirclingPair) {
  constexpr double distance = 0.99;
  constexpr int steps_a_turn = 250;
  constexpr int steps = 10 * steps_a_turn;
  const double angle = 2 * std::numbers::pi / steps_a_turn;
  // In steps of this angle: chords, held by a force that turns the velocity by it.
  const double spin =
      (TypeParam::synchronized ? 2 * std::tan(angle / 2) : distance * std::sin(angle)) / time_step;
  Packing start = unstoppable_pair(distance, {0, 0, spin}, {0, 3e-3, 4e-3});
  const double speed = distance / 2 * std::sin(angle) / time_step;
  start.velocity = {{0, -speed, 0}, {0, speed, 0}};
  const double pull = start.mass[0] * 2 * (1 - std::cos(angle)) / (time_step * time_step);
  const V middle{8, 8, 8};
  Driven<TypeParam> run(
      model_of<TypeParam>({.normal_damping = 0, .tangential_damping = 0, .friction = no_sliding}, time_step),
      start, [&](std::size_t, const V& position, double) { return pull * (middle - position); });
  run.advance(steps);
  const double kept = TypeParam::synchronized ? 1 : std::pow(std::cos(angle), steps);
  // Places in the cell are read to 2e-15 in each step.
  EXPECT_LT(norm(run.position(1) - V{8 + distance / 2, 8, 8}), 1e-10);
  EXPECT_LT(norm(run.history(1, 0) - V{0, 3e-3 * kept, 4e-3}), steps * 4e-15);
}

// T14 through the engine: both spin about the normal.
TYPED_TEST(History, TwistsWithASpinningPair) {
  constexpr int steps = 500;
  constexpr double angle = 0.01;
  Packing start = unstoppable_pair(0.99, {angle / time_step, 0, 0}, {0, 1e-3, 0});
  start.order = {0, 1};
  const Packing end = after(
      model_of<TypeParam>({.normal_damping = 0, .tangential_damping = 0, .friction = no_sliding}, time_step),
      start, steps);
  ASSERT_EQ(end.contacts.size(), 1u);
  const double sign = end.contacts[0].i == 1 ? 1 : -1;
  const double turned = TypeParam::synchronized ? steps * 2 * std::atan(angle / 2) : 0;
  EXPECT_LT(norm(sign * end.contacts[0].history - V{0, 1e-3 * std::cos(turned), 1e-3 * std::sin(turned)}),
            1e-10 * 1e-3);
}

// T16: F_n constant, the surfaces displaced through the threshold and back: |F_t| = min(k_t |x|, mu F_n)
// without a jump, slope k_t after the reversal, no slipping and sticking to and fro.
TYPED_TEST(History, SticksSlipsAndReversesOnce) {
  constexpr double friction = 0.5;
  constexpr double overlap = 0.01;
  constexpr double increment = 1e-4;
  constexpr double limit = friction * overlap;
  const TypeParam law{{.normal_damping = 0, .tangential_damping = 0, .friction = friction}};
  Touch<double> t = touch_at_rest(overlap);
  const double arm = TypeParam::synchronized ? 0.5 - overlap / 2 : 0.5;
  V xi;
  double force = 0;
  int toggles = 0;
  bool slipping = false;
  for (int n = 0; n < 300; ++n) {
    const double displacement = n < 100 ? increment : -increment;
    // A spin of i about z moves its surface at the contact along -y.
    t.midway.spin_i = {0, 0, -displacement / (arm * time_step)};
    const Reaction<double> r = law(t, xi);
    EXPECT_NEAR(r.force.x, overlap, 1e-15);
    EXPECT_LE(std::hypot(r.force.y, r.force.z), limit * (1 + 4e-16));
    const double expected = std::clamp(force - displacement, -limit, limit);
    EXPECT_NEAR(r.force.y, expected, 1e-15);
    force = r.force.y;
    const bool slips = std::abs(force) > limit * (1 - 1e-9);
    toggles += slips != slipping;
    slipping = slips;
  }
  EXPECT_EQ(toggles, 3);  // slips, sticks at the reversal, slips again
}

// T16: at the threshold to the last bits: |F_t| never exceeds mu F_n, whichever way the surfaces move.
TYPED_TEST(History, NeverExceedsCoulombAtTheThreshold) {
  constexpr double friction = 0.3;
  constexpr double overlap = 1e-4;
  const TypeParam law{{.tangential_damping = 0, .friction = friction}};
  Touch<double> t = touch_at_rest(overlap);
  V xi{0, -friction * t.overlap, 0};
  double force = friction * t.overlap;
  for (int n = 0; n < 1000; ++n) {
    const double displacement = (n % 2 == 0 ? 1 : -1) * 1e-12 * t.overlap;
    t.midway.spin_i = {0, 0, displacement / (0.5 * time_step)};
    const Reaction<double> r = law(t, xi);
    EXPECT_LE(std::hypot(r.force.y, r.force.z), friction * r.force.x * (1 + 4e-16));
    EXPECT_NEAR(r.force.y, force, 2e-12 * t.overlap);
    force = r.force.y;
  }
}

// T19: F_n falls while the surfaces rest: |xi| is cut to mu F_n/k_t and does not grow again.
TYPED_TEST(History, IsCutAsTheNormalForceFalls) {
  constexpr double friction = 0.4;
  const TypeParam law{{.normal_damping = 0, .tangential_damping = 0, .friction = friction}};
  V xi{0, 3e-3, 4e-3};
  for (double overlap : {0.02, 0.0125, 0.01, 0.005, 0.001, 0.01}) {
    const double before = norm(xi);
    law(touch_at_rest(overlap), xi);
    EXPECT_NEAR(norm(xi), std::min(before, friction * overlap), 1e-17);
    EXPECT_NEAR(xi.y / xi.z, 0.75, 1e-14);
  }
}

// T19: a contact that opens and closes again starts without history: with the slip of its first step, no
// more. A spinning sphere flies to and fro between another and its image, never far enough to leave the
// neighbour list.
TYPED_TEST(History, IsLostWhenTheContactOpens) {
  Model model = model_of<TypeParam>({.normal_damping = 0, .tangential_damping = 0, .friction = no_sliding});
  model.skin = 0.5;
  const auto simulation = make_simulation(
      model, packing_of({2.3, 16, 16, 0, 0, 0},
                        {{.position = {1.15, 8, 8}, .velocity = {0.1, 0, 0}, .spin = {0, 0, 0.1}},
                         {.position = {0, 8, 8}}}));
  int meetings = 0;
  double lost = 0;
  Packing before = simulation->packing();
  for (int step = 0; step < 800; ++step) {
    simulation->advance(1);
    const Packing now = simulation->packing();
    if (before.contacts.empty() && !now.contacts.empty()) {
      ++meetings;
      const V n = now.contacts[0].branch * (1 / norm(now.contacts[0].branch));
      const V v = before.velocity[0] - before.velocity[1];
      const double slip = norm(v - dot(v, n) * n) + 0.5 * norm(before.spin[0] + before.spin[1]);
      EXPECT_LE(norm(now.contacts[0].history), 1.01 * slip * paper_step) << step;
    }
    if (!before.contacts.empty() && now.contacts.empty())
      lost = std::max(lost, norm(before.contacts[0].history));
    before = now;
  }
  EXPECT_GT(meetings, 4);
  EXPECT_GT(lost, 0.01);  // several times the slip of a step
}

// T19: histories survive a new list: with one in every step and with none on the way a packing keeps every
// bit.
TYPED_TEST(History, SurvivesANewList) {
  const auto run = [](double skin) {
    Model model = model_of<TypeParam>({.friction = 0.3});
    model.skin = skin;
    const auto simulation = make_simulation(model, squeezed(1e-3));
    simulation->advance(100);
    return std::pair{simulation->packing(), simulation->neighbours().builds};
  };
  const auto [often, many] = run(0);
  const auto [once, one] = run(0.5);
  EXPECT_GT(many, 100);
  EXPECT_EQ(one, 1);
  EXPECT_EQ(often.velocity, once.velocity);
  EXPECT_EQ(often.spin, once.spin);
  ASSERT_EQ(often.contacts.size(), once.contacts.size());
  double largest = 0;
  for (std::size_t n = 0; n < once.contacts.size(); ++n) {
    EXPECT_EQ(often.contacts[n].history, once.contacts[n].history);
    largest = std::max(largest, norm(once.contacts[n].history));
  }
  EXPECT_GT(largest, 1e-4);
}

// T19: a contact that crosses the face of the cell moves as its twin in the middle does, to the bit.
TYPED_TEST(History, CrossesTheFaceOfTheCell) {
  const auto run = [](double shift) {
    const V together{3, -2, 1};
    const std::vector<Ball> balls{
        {.position = {7.0 + shift, 9.0 + shift, 8.5 + shift}, .velocity = together, .spin = {0, 0.2, 0.1}},
        {.position = {8.25 + shift, 8.5 + shift, 8.5 + shift},
         .velocity = together + V{-0.2, 0.1, 0.05},
         .radius = 1}};
    const auto simulation =
        make_simulation(model_of<TypeParam>({.friction = 0.5}), packing_of(cube(32), balls));
    std::vector<Packing> states;
    for (int step = 0; step < 80; ++step) {
      simulation->advance(1);
      states.push_back(simulation->packing());
    }
    return states;
  };
  const auto twin = run(0);
  for (double shift : {-8.5, 22.0}) {
    const auto crossing = run(shift);
    int touching = 0;
    bool crossed = false;
    for (std::size_t n = 0; n < twin.size(); ++n) {
      ASSERT_EQ(crossing[n].velocity, twin[n].velocity) << n;
      ASSERT_EQ(crossing[n].spin, twin[n].spin) << n;
      ASSERT_EQ(crossing[n].contacts.size(), twin[n].contacts.size());
      if (twin[n].contacts.empty()) continue;
      ++touching;
      ASSERT_EQ(crossing[n].contacts[0].history, twin[n].contacts[0].history) << n;
      crossed |= crossing[n].image[0] != crossing[n].image[1];
    }
    EXPECT_GT(touching, 20);
    EXPECT_TRUE(crossed);
  }
}

}  // namespace
}  // namespace furnas
