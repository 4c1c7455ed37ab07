#include "engine/simulation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/base/require.h"
#include "engine/events/flip.h"
#include "engine/monitor/energy.h"
#include "tests/engine/laws/every_law.h"
#include "tests/engine/support/same_packing.h"
#include "tests/engine/support/setups.h"
#include "tests/engine/support/symmetries.h"

namespace furnas {
namespace {

template <class Law>
class Invariance : public testing::Test {
 protected:
  const Model model = model_of<Law>({.friction = 0.3});
};
TYPED_TEST_SUITE(Invariance, EveryLaw, LawName);

Packing translated(Packing p, const Fraction& by) {
  for (Fraction& s : p.fraction) s = {s.x + by.x, s.y + by.y, s.z + by.z};
  return p;
}

/// A start: without contacts, history and order in memory.
Packing forgotten(Packing p) {
  p.order.clear();
  p.contacts.clear();
  return p;
}

// T24: a translation, arbitrary through the faces of the cell, changes no bit as long as the order in memory
// stays: positions are integers.
TYPED_TEST(Invariance, TranslationChangesNoBit) {
  Model worn = this->model;
  worn.skin = 0.02;  // so that lists are built on the way
  const Packing here = squeezed(1e-2);
  const Packing there = translated(here, to_fraction({0.3717, 0.5113, -0.2391}));
  const auto a = make_simulation(worn, here);
  const auto b = make_simulation(worn, there);
  a->advance(300);
  b->advance(300);
  EXPECT_GT(a->neighbours().builds, 3);
  EXPECT_EQ(a->neighbours().builds, b->neighbours().builds);
  const Packing p = a->packing();
  const Packing q = b->packing();
  EXPECT_EQ(p.velocity, q.velocity);
  EXPECT_EQ(p.spin, q.spin);
  EXPECT_EQ(p.force, q.force);
  EXPECT_EQ(p.torque, q.torque);
  EXPECT_EQ(p.stress.contacts, q.stress.contacts);
  ASSERT_EQ(p.contacts.size(), q.contacts.size());
  for (std::size_t n = 0; n < p.contacts.size(); ++n) {
    EXPECT_EQ(p.contacts[n].history, q.contacts[n].history);
    EXPECT_EQ(p.contacts[n].image, q.contacts[n].image);
  }
}

// T24: with an order of its own the sums run differently: one step agrees to 1e-12.
TYPED_TEST(Invariance, TranslationWithAnotherOrderAgreesToRounding) {
  const Packing here = forgotten(squeezed(1e-2));
  const Packing there = translated(here, to_fraction({0.3717, 0.5113, -0.2391}));
  const Packing p = after(this->model, here, 1);
  const Packing q = after(this->model, there, 1);
  EXPECT_NE(p.order, q.order);
  EXPECT_LT(largest_difference(p.velocity, q.velocity), 1e-12);
  EXPECT_LT(largest_difference(p.force, q.force), 1e-12);
  EXPECT_LT(largest_difference(p.torque, q.torque), 1e-12);
}

// T25: a velocity given to all particles changes nothing that is relative.
TYPED_TEST(Invariance, BoostChangesNothingRelative) {
  const Vec3<double> boost{0.37, -0.21, 0.11};
  const Packing rest = squeezed(1e-3);
  Packing moving = rest;
  for (Vec3<double>& v : moving.velocity) v += boost;
  const Packing p = after(this->model, rest, 1000);
  Packing q = after(this->model, moving, 1000);
  for (Vec3<double>& v : q.velocity) v -= boost;
  ASSERT_EQ(p.contacts.size(), q.contacts.size());
  EXPECT_LT(largest_difference(p.velocity, q.velocity), 1e-10);
  EXPECT_LT(largest_difference(p.spin, q.spin), 1e-10);
  EXPECT_LT(largest_difference(p.force, q.force), 1e-10);
}

using test::expect_same_contacts;

constexpr int lattices[][3] = {{1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {1, -1, 1}, {-1, 2, -1}};

// T27: the same lattice described by other edges: same contacts, forces, stress and history.
TYPED_TEST(Invariance, OtherEdgesOfTheLatticeChangeNothing) {
  const Packing start = squeezed(1e-3);
  const Packing now = after(this->model, start, 0);
  const Packing next = after(this->model, start, 1);
  for (const auto& [xy, xz, yz] : lattices) {
    const Packing other = reskewed(start, xy, xz, yz);
    const Packing p = after(this->model, other, 0);
    expect_same_contacts(now, p, 1e-13);
    const Packing q = after(this->model, other, 1);
    expect_same_contacts(next, q, 1e-13);
    EXPECT_LT(largest_difference(next.force, q.force), 1e-13);
    EXPECT_LT(largest_difference(next.torque, q.torque), 1e-13);
    EXPECT_LT((next.stress.contacts - q.stress.contacts).norm(), 1e-13 * next.stress.contacts.norm());
  }
}

/// The cell may move and is being sheared.
Model in_a_moving_cell(Model model) {
  model.barostat = {.inertia = inertia_of_cell(jammed())};
  return model;
}

// T27: in a run too, the cell moving: rate, stress and energy go on as if nothing had happened.
TYPED_TEST(Invariance, OtherEdgesOfTheLatticeLetARunGoOn) {
  Packing start = squeezed(1e-3);
  start.cell.rate = {0, 0, 0, 1e-3, -1e-3, 1e-3};
  const Packing p = after(in_a_moving_cell(this->model), start, 100);
  for (const auto& [xy, xz, yz] : lattices) {
    const Packing q = after(in_a_moving_cell(this->model), reskewed(start, xy, xz, yz), 100);
    EXPECT_NEAR(kinetic_energy(p), kinetic_energy(q), 1e-10 * kinetic_energy(p));
    EXPECT_NEAR(p.cell.volume(), q.cell.volume(), 1e-11 * p.cell.volume());
    EXPECT_NEAR(p.cell.rate.xy, q.cell.rate.xy, 1e-12);
    EXPECT_NEAR(p.cell.rate.zz, q.cell.rate.zz, 1e-12);
    expect_same_contacts(p, q, 1e-11);
  }
}

// T27: the flip of the cell is such a description, and shortens the edges.
TYPED_TEST(Invariance, FlipChangesNothing) {
  const Packing start = squeezed(1e-3);
  const Packing next = after(this->model, start, 1);
  for (const auto& [xy, xz, yz] : lattices) {
    Packing flipped = reskewed(start, xy, xz, yz);
    ASSERT_TRUE(flip_cell(flipped));
    const Triangle& h = flipped.cell.edges;
    EXPECT_LE(std::max(std::abs(h.xy), std::abs(h.xz)), 0.5 * h.xx);
    EXPECT_LE(std::abs(h.yz), 0.5 * h.yy);
    const Packing q = after(this->model, flipped, 1);
    expect_same_contacts(next, q, 1e-13);
    EXPECT_LT(largest_difference(next.force, q.force), 1e-13);
  }
}

/// A packing in motion, its cell too, with histories.
Packing moving(const Model& model) {
  Packing start = squeezed(1e-2);
  start.cell.rate = {1e-3, -1e-3, 0, 1e-3, -1e-3, 1e-3};
  return after(model, start, 50);
}

// Another motion is what a packing with other velocities would be, but for the list, which stays.
TYPED_TEST(Invariance, ANewMotionIsThatOfAPackingWithIt) {
  const Model moves = in_a_moving_cell(this->model);
  const auto changed = make_simulation(moves, moving(moves));
  Packing wanted = changed->packing();
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    wanted.velocity[k] = -0.5 * wanted.velocity[k];
    wanted.spin[k] = 0.25 * wanted.spin[k];
  }
  wanted.cell.rate = {1e-4, 0, 2e-4, 0, 0, -1e-4};
  changed->set_motion(wanted.velocity, wanted.spin, wanted.cell.rate);
  const auto loaded = make_simulation(moves, wanted);
  // The ledger of the changed packing has booked the motion that was taken out.
  EXPECT_TRUE(test::same_state(changed->packing(), wanted));
  changed->advance(100);
  loaded->advance(100);
  EXPECT_TRUE(test::same_state(changed->packing(), loaded->packing()));
}

// A cell that may not make a strain does not go on with its rate, wherever the packing is from.
TYPED_TEST(Invariance, ACellMovesAsItIsFreeTo) {
  Packing start = moving(this->model);
  start.cell.rate = {1e-3, 4e-3, 1e-3, 1e-3, -1e-3, 1e-3};
  const auto rate_with = [&](CellFreedom freedom) {
    Model model = this->model;
    model.barostat.freedom = freedom;
    const auto simulation = make_simulation(model, start);
    const Triangle loaded = simulation->packing().cell.rate;
    const std::vector<Vec3<double>> none(start.size());
    simulation->set_motion(none, none, start.cell.rate);
    EXPECT_EQ(simulation->packing().cell.rate, loaded);
    return loaded;
  };
  EXPECT_EQ(rate_with(CellFreedom::triclinic), start.cell.rate);
  EXPECT_EQ(rate_with(CellFreedom::orthorhombic), (Triangle{1e-3, 4e-3, 1e-3, 0, 0, 0}));
  EXPECT_EQ(rate_with(CellFreedom::cubic), (Triangle{2e-3, 2e-3, 2e-3, 0, 0, 0}));
  EXPECT_EQ(rate_with(CellFreedom::fixed), Triangle{});
}

// The energy that a stop takes out is booked: the balance closes as well as it did.
TYPED_TEST(Invariance, AStopIsBooked) {
  const Model moves = in_a_moving_cell(this->model);
  const auto simulation = make_simulation(moves, moving(moves));
  const auto gap = [&] {
    const Packing p = simulation->packing();
    return p.ledger.gap(energy(p, moves.law).total());
  };
  const double before = gap(), moved = energy(simulation->packing(), moves.law).kinetic;
  const std::vector<Vec3<double>> none(simulation->packing().size());
  simulation->set_motion(none, none, {});
  EXPECT_EQ(energy(simulation->packing(), moves.law).kinetic, 0);
  EXPECT_NEAR(gap(), before, 1e-12 * moved);
  EXPECT_NEAR(simulation->packing().ledger.quenched, moved, 1e-12 * moved);
}

// Between its faces a collapsed cell has no room for a list; what is left can still be measured and saved.
TYPED_TEST(Invariance, ACellThatCollapsesAtANewStartCanStillBeMeasured) {
  const auto simulation = make_simulation(this->model, moving(this->model));
  Packing flat = simulation->packing();
  flat.cell.edges.zz *= 1e-6;
  EXPECT_THROW(simulation->load(flat), NumericalFailure);
  const Packing left = simulation->packing();
  EXPECT_EQ(left.fraction, flat.fraction);
  EXPECT_EQ(left.image, flat.image);
  EXPECT_TRUE(left.contacts.empty());
  EXPECT_EQ(simulation->neighbours().builds, 1) << "of the list that the first start needed";
  EXPECT_EQ(simulation->neighbours().inner_pairs, 0U);
}

TYPED_TEST(Invariance, AHistoryThatIsNoNumberIsRefused) {
  Packing start = moving(this->model);
  ASSERT_FALSE(start.contacts.empty());
  start.contacts.front().history.y = std::nan("");
  EXPECT_THROW(make_simulation(this->model, start), InputError);
}

TYPED_TEST(Invariance, ContactsOfPairsThatAreNoneAreRefused) {
  const auto simulation = make_simulation(this->model, moving(this->model));
  simulation->advance(1);
  Packing wrong = simulation->packing();
  Contact far;
  far.i = 0, far.j = 1, far.image = {7, 0, 0};
  wrong.contacts.push_back(far);
  EXPECT_THROW(make_simulation(this->model, wrong), InputError);
  wrong.contacts.back().j = static_cast<std::uint32_t>(wrong.size());
  EXPECT_THROW(make_simulation(this->model, wrong), InputError);
}

}  // namespace
}  // namespace furnas
