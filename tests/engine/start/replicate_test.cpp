#include "engine/start/replicate.h"

#include <gtest/gtest.h>

#include <set>

#include "engine/base/require.h"
#include "engine/simulation.h"
#include "tests/engine/support/brute_force.h"
#include "tests/engine/support/property.h"
#include "tests/engine/support/random_packing.h"
#include "tests/engine/support/same_packing.h"
#include "tests/engine/support/setups.h"

namespace furnas {
namespace {

using test::Dice;
using test::TouchName;

/// How far the vectors of all copies are from those of the original.
double largest_deviation(const std::vector<Vec3<double>>& copies, const std::vector<Vec3<double>>& original) {
  double largest = 0;
  for (std::size_t k = 0; k < copies.size(); ++k)
    largest = std::max(largest, norm(copies[k] - original[k % original.size()]));
  return largest;
}

TEST(Replicate, OnceIsTheSamePacking) {
  Packing once = replicate(jammed(), {1, 1, 1});
  once.order = jammed().order;
  EXPECT_TRUE(test::same_packing(once, jammed()));
}

TEST(Replicate, GoesOnWithItsContactsAndTheirHistories) {
  const Packing& original = jammed();
  const Packing after_original = after(jammed_model(), original, 200);
  for (const Times& times : {Times{2, 2, 2}, Times{3, 1, 2}}) {
    const auto simulation = make_simulation(jammed_model(), replicate(original, times));
    Packing p = simulation->packing();
    ASSERT_EQ(p.size(), original.size() * copies_of(times));
    EXPECT_EQ(p.contacts.size(), original.contacts.size() * copies_of(times));
    EXPECT_NEAR(p.fraction_filled(), original.fraction_filled(), 1e-14);
    simulation->advance(200);
    p = simulation->packing();
    EXPECT_EQ(p.contacts.size(), after_original.contacts.size() * copies_of(times));
    EXPECT_LT(largest_deviation(p.force, after_original.force), 1e-11);
    EXPECT_LT(largest_deviation(p.velocity, after_original.velocity), 1e-11);
    EXPECT_LT(largest_deviation(p.spin, after_original.spin), 1e-11);
  }
}

TEST(Replicate, TakesTheSameForcesAsAStart) {
  Packing start = jammed();
  start.order.clear();
  const Packing fresh = make_simulation(jammed_model(), start)->packing();
  const Packing p = make_simulation(jammed_model(), replicate(start, {2, 3, 1}))->packing();
  EXPECT_EQ(p.contacts.size(), 6 * fresh.contacts.size());
  EXPECT_LT(largest_deviation(p.force, fresh.force), 1e-13);
  EXPECT_LT(largest_deviation(p.torque, fresh.torque), 1e-13);
  EXPECT_NEAR(p.stress.contacts.trace(), 6 * fresh.stress.contacts.trace(),
              1e-12 * p.stress.contacts.trace());
}

/// With the inertia in proportion the cell of the replicate answers as the original's; what is left is its
/// share in the kinetic energy of a particle, 1/N.
TEST(Replicate, StaysPeriodicUnderThePressureOfTheBath) {
  const Packing& original = jammed();
  Model model = jammed_model();
  model.barostat.freedom = CellFreedom::triclinic;
  model.barostat.pressure = 2e-4;
  model.barostat.inertia = inertia_of_cell(original);
  const Packing small = after(model, original, 200);
  model.barostat.inertia *= 8;
  const Packing large = after(model, replicate(original, {2, 2, 2}), 200);
  EXPECT_GT(std::abs(small.fraction_filled() - original.fraction_filled()), 1e-5);
  EXPECT_NEAR(large.fraction_filled(), small.fraction_filled(), 1e-7);
  EXPECT_LT(largest_deviation(large.force, small.force), 1e-6);
}

TEST(Replicate, KeepsTheWaysOfItsParticles) {
  Packing p = packing_of(cube(4), {{.position = {1, 2, 3}}});
  p.image[0] = {5, -7, 0};
  const Packing many = replicate(p, {3, 2, 1});
  std::set<std::array<long, 3>> apart;
  for (std::size_t k = 0; k < many.size(); ++k) {
    const Vec3<double> displacement = 0.25 * (many.unwrapped(k) - p.unwrapped(0));
    EXPECT_NEAR(displacement.x, std::round(displacement.x), 1e-12);
    EXPECT_NEAR(displacement.y, std::round(displacement.y), 1e-12);
    apart.insert({std::lround(displacement.x), std::lround(displacement.y), std::lround(displacement.z)});
  }
  EXPECT_EQ(apart, (std::set<std::array<long, 3>>{
                       {0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}}));
}

TEST(Replicate, UntanglesASphereThatTouchesItself) {
  const Packing crystal =
      make_simulation(jammed_model(), packing_of(cube(0.99), {{.position = {0.4, 0.1, 0}}}))->packing();
  ASSERT_EQ(crystal.contacts.size(), 3U);
  const auto simulation = make_simulation(jammed_model(), replicate(crystal, {3, 2, 1}));
  const Packing p = simulation->packing();
  ASSERT_EQ(p.contacts.size(), 18U);
  for (const Contact& c : p.contacts) EXPECT_NEAR(norm(c.force), 0.01, 1e-15);
}

/// Particles on faces, cells of all angles, several images of one partner: the contacts of the replicate are
/// those that brute force finds.
TEST(Replicate, HasEveryContactOfAnyPacking) {
  EXPECT_TRUE(test::holds(100, [] {
    Dice dice(test::any_seed());
    test::RandomPacking wanted;
    wanted.cell = dice.between(1.5, 5);
    wanted.size_ratio = dice.chance(0.5) ? 1 : 3;
    const Packing p = make_simulation(jammed_model(), test::random_packing(dice, wanted))->packing();
    // Centres as near as the integers can tell would fall together.
    for (const Contact& c : p.contacts) RC_PRE(norm(c.branch) > 1e-9);
    const auto draw = [&] { return static_cast<std::int32_t>(1 + dice.below(3)); };
    const Packing many = replicate(p, {draw(), draw(), draw()});
    std::set<TouchName> names;
    for (const Contact& c : many.contacts) RC_ASSERT(names.insert(test::name_of(many, c)).second);
    // A touch of points is open to rounding.
    for (const auto& [name, touch] : test::brute_pairs(many, -1e-12)) RC_ASSERT(names.contains(name));
    const auto about = test::brute_pairs(many, 1e-12);
    for (const TouchName& name : names) RC_ASSERT(about.contains(name));
    make_simulation(jammed_model(), many);  // takes every contact
  }));
}

TEST(Replicate, RefusesWhatCannotBe) {
  EXPECT_THROW(replicate(jammed(), {0, 1, 1}), InputError);
  EXPECT_THROW(replicate(jammed(), {10000, 10000, 10000}), InputError);
}

}  // namespace
}  // namespace furnas
