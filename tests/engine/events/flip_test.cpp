#include "engine/events/flip.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>
#include <tuple>

#include "engine/events/limits.h"
#include "engine/start/mixture.h"
#include "tests/engine/support/setups.h"

namespace furnas {
namespace {

constexpr double rounding = 1e-13;

/// Spheres of two sizes that overlap and have slid for a few steps, in a cell with the given tilts in units
/// of the edge they lean along. The cell is so small that large spheres meet several images.
Packing tilted_packing(unsigned seed, double yz, double xz, double xy) {
  Packing p = dilute_start(
      {.size_ratio = 3, .small_fraction = 0.3, .large = 1, .start_fraction = 0.25, .seed = seed});
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> speed(-0.1, 0.1);
  for (std::size_t k = 0; k < p.size(); ++k) {
    p.velocity[k] = {speed(random), speed(random), speed(random)};
    p.image[k] = {static_cast<int>(random() % 5) - 2, static_cast<int>(random() % 5) - 2, 1};
  }
  const double edge = 0.7 * p.cell.edges.xx;
  p.cell.edges = {edge, 0.9 * edge, 1.1 * edge, yz * 0.9 * edge, xz * edge, xy * edge};
  const auto simulation = make_simulation(jammed_model(), p);
  simulation->advance(5);
  return simulation->packing();
}

/// Six large tilts that need every kind of relabelling, and the random ones of a seed.
std::array<double, 3> tilts(unsigned seed) {
  constexpr std::array<std::array<double, 3>, 6> table{
      {{0.6, 0, 0}, {0, -0.6, 0}, {0, 0, 0.6}, {1.4, 1.4, 1.4}, {-1.3, 0.7, 1.2}, {0.9, -1.1, -0.6}}};
  if (seed < table.size()) return table[seed];
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> tilt(-1.4, 1.4);
  return {tilt(random), tilt(random), tilt(random)};
}

/// The branch of a contact from what names it: places, image and cell.
Vec3<double> branch_of(const Packing& p, const Contact& c) {
  const Vec3<double> d = nearest_difference(p.fraction[c.i], p.fraction[c.j]);
  return p.cell.edges * Vec3<double>{d.x + c.image[0], d.y + c.image[1], d.z + c.image[2]};
}

TEST(FlipCell, LeavesACellAloneUpToItsMargin) {
  for (double tilt : {0.0, 0.5, -0.549, 0.549}) {
    for (const Triangle& h : {Triangle{2, 3, 4, tilt * 3, 0, 0}, Triangle{2, 3, 4, 0, tilt * 2, 0},
                              Triangle{2, 3, 4, 0, 0, tilt * 2}}) {
      Packing p;
      p.cell.edges = h;
      EXPECT_FALSE(flip_cell(p));
      EXPECT_EQ(p.cell.edges, h);
    }
  }
}

TEST(FlipCell, ShortensTheEdgesOfTheSameLattice) {
  int flipped = 0;
  for (unsigned seed = 0; seed < 2000; ++seed) {
    const auto [yz, xz, xy] = tilts(seed);
    Packing p;
    p.cell.edges = {2, 3, 4, yz * 3, xz * 2, xy * 2};
    p.cell.rate = {1, 2, 3, 4, 5, 6};
    const Cell before = p.cell;
    const bool needed = std::max({std::abs(yz), std::abs(xz), std::abs(xy)}) > 0.55;
    ASSERT_EQ(flip_cell(p), needed);
    if (!needed) continue;
    ++flipped;
    const Triangle& h = p.cell.edges;
    EXPECT_LE(std::abs(h.yz), 0.5 * h.yy);
    EXPECT_LE(std::abs(h.xz), 0.5 * h.xx + rounding);
    EXPECT_LE(std::abs(h.xy), 0.5 * h.xx);
    EXPECT_EQ(p.cell.rate, before.rate);
    EXPECT_EQ(p.cell.volume(), before.volume());
    const Triangle m = product(inverse(before.edges), h);  // whole numbers with ones along the diagonal
    EXPECT_NEAR(m.xx, 1, rounding);
    EXPECT_NEAR(m.yy, 1, rounding);
    EXPECT_NEAR(m.zz, 1, rounding);
    for (double entry : {m.yz, m.xz, m.xy}) EXPECT_NEAR(entry, std::nearbyint(entry), rounding);
  }
  EXPECT_GT(flipped, 1000);
}

TEST(FlipCell, EveryContactKeepsItsBranch) {
  std::size_t beyond_the_nearest = 0;
  for (unsigned seed = 0; seed < 40; ++seed) {
    const auto [yz, xz, xy] = tilts(seed);
    const Packing before = tilted_packing(seed, yz, xz, xy);
    Packing after = before;
    flip_cell(after);
    ASSERT_GT(before.contacts.size(), 10u);
    ASSERT_EQ(after.contacts.size(), before.contacts.size());
    for (std::size_t n = 0; n < after.contacts.size(); ++n) {
      const Contact& c = after.contacts[n];
      EXPECT_LT(norm(branch_of(after, c) - branch_of(before, before.contacts[n])), rounding);
      EXPECT_LT(norm(branch_of(after, c) - c.branch), rounding);
      beyond_the_nearest += c.image != decltype(c.image){};
    }
  }
  EXPECT_GT(beyond_the_nearest, 100u) << "the cells are too large to test images";
}

TEST(FlipCell, EveryParticleStaysWhereItIs) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    const auto [yz, xz, xy] = tilts(seed);
    const Packing before = tilted_packing(seed, yz, xz, xy);
    Packing after = before;
    flip_cell(after);
    for (std::size_t k = 0; k < after.size(); ++k) {
      EXPECT_LT(norm(after.unwrapped(k) - before.unwrapped(k)), 1e-12) << "particle " << k << " of " << seed;
      EXPECT_EQ(after.velocity[k], before.velocity[k]);
      EXPECT_EQ(after.spin[k], before.spin[k]);
    }
  }
}

using Name = std::tuple<std::uint32_t, std::uint32_t, std::array<std::int8_t, 3>>;

/// Contacts by their names. A particle meets itself on two opposite images; the contact goes by the lower.
std::map<Name, Contact> by_name(const Packing& p) {
  std::map<Name, Contact> contacts;
  for (Contact c : p.contacts) {
    if (c.i == c.j && c.image > decltype(c.image){}) {
      for (auto& k : c.image) k = static_cast<std::int8_t>(-k);
      c.branch = -c.branch, c.force = -c.force, c.history = -c.history;
    }
    contacts.emplace(Name{c.i, c.j, c.image}, c);
  }
  return contacts;
}

/// The engine finds the relabelled contacts where flip_cell says they are, and goes on from them.
TEST(FlipCell, TheEngineGoesOnFromIt) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    const auto [yz, xz, xy] = tilts(seed);
    const Packing before = tilted_packing(seed, yz, xz, xy);
    Packing flipped = before;
    flip_cell(flipped);
    const auto simulation = make_simulation(jammed_model(), flipped);
    const Packing loaded = simulation->packing();
    EXPECT_EQ(loaded.stress.contacts, before.stress.contacts);
    EXPECT_EQ(loaded.stress.motion, before.stress.motion);
    EXPECT_EQ(loaded.force, before.force);
    EXPECT_EQ(loaded.torque, before.torque);
    EXPECT_EQ(loaded.image, flipped.image);
    const auto expected = by_name(flipped);
    const auto found = by_name(loaded);
    ASSERT_EQ(found.size(), expected.size());
    for (const auto& [name, contact] : expected) {
      ASSERT_TRUE(found.contains(name));
      EXPECT_EQ(found.at(name).history, contact.history);
      EXPECT_EQ(found.at(name).force, contact.force);
      EXPECT_EQ(found.at(name).sliding, contact.sliding);
      EXPECT_LT(norm(found.at(name).branch - contact.branch), rounding);
    }
  }
}

TEST(FlipCell, TheMotionGoesOnAsWithoutIt) {
  for (unsigned seed = 0; seed < 12; ++seed) {
    const auto [yz, xz, xy] = tilts(seed);
    const Packing before = tilted_packing(seed, yz, xz, xy);
    Packing flipped = before;
    flip_cell(flipped);
    const auto with = make_simulation(jammed_model(), flipped);
    const auto without = make_simulation(jammed_model(), before);
    with->advance(20);
    without->advance(20);
    const Packing a = with->packing();
    const Packing b = without->packing();
    ASSERT_EQ(a.contacts.size(), b.contacts.size());
    EXPECT_LT((a.stress.total() - b.stress.total()).norm(), 1e-11);
    for (std::size_t k = 0; k < a.size(); ++k) {
      EXPECT_LT(norm(a.unwrapped(k) - b.unwrapped(k)), 1e-11);
      EXPECT_LT(norm(a.velocity[k] - b.velocity[k]), 1e-11);
      EXPECT_LT(norm(a.spin[k] - b.spin[k]), 1e-11);
    }
  }
}

/// A cell whose edges are whole multiples of each other's, with the whole tilts that undo a relabelling:
/// places and images come back bit by bit.
TEST(FlipCell, FlippingBackIsExact) {
  for (unsigned seed = 0; seed < 27; ++seed) {
    const int yz = static_cast<int>(seed % 3) - 1;
    const int xz = static_cast<int>(seed / 3 % 3) - 1;
    const int xy = static_cast<int>(seed / 9) - 1;
    if (yz == 0 && xz == 0 && xy == 0) continue;
    const Packing before = tilted_packing(seed, 0, 0, 0);
    Packing p = before;
    const double a = 8;
    // c is to lose yz times b and xz times a, b to lose xy times a; then each is to gain it again.
    p.cell.edges = {a, a, a, yz * a, (xz + yz * xy) * a, xy * a};
    ASSERT_TRUE(flip_cell(p));
    EXPECT_EQ(p.cell.edges, (Triangle{a, a, a, 0, 0, 0}));
    EXPECT_NE(p.fraction, before.fraction);
    p.cell.edges = {a, a, a, -yz * a, -xz * a, -xy * a};
    ASSERT_TRUE(flip_cell(p));
    EXPECT_EQ(p.cell.edges, (Triangle{a, a, a, 0, 0, 0}));
    EXPECT_EQ(p.fraction, before.fraction);
    EXPECT_EQ(p.image, before.image);
    for (std::size_t n = 0; n < p.contacts.size(); ++n)
      EXPECT_EQ(p.contacts[n].image, before.contacts[n].image);
  }
}

double energy(const Packing& p) { return elastic_energy(p) + kinetic_energy(p); }

/// A cell that is sheared at a constant rate, because nothing can stop its inertia.
Model sheared_model() {
  Model model = jammed_model();
  model.barostat = {.freedom = CellFreedom::triclinic, .pressure = 1e-4, .inertia = 1e30};
  return model;
}

TEST(Flip, AShearedRunDoesNotNoticeIt) {
  Packing start = tilted_packing(3, 0.5, -0.5, 0.5);
  start.order.clear();
  start.step = 0;
  start.cell.rate = {.yz = 0.02, .xz = -0.02, .xy = 0.02};
  const auto flipping = make_simulation(sheared_model(), start);
  const auto tilting = make_simulation(sheared_model(), start);
  Observation now(*flipping, 3);
  Events events;
  events.push_back(std::make_unique<Flip>(100));
  events.push_back(std::make_unique<Budget>(130));
  ASSERT_EQ(compact(now, events), Verdict::budget);
  EXPECT_EQ(static_cast<const Flip&>(*events.front()).count(), 1);
  tilting->advance(130);
  const Packing a = flipping->packing();
  const Packing b = tilting->packing();
  EXPECT_LT(std::abs(a.cell.edges.xy), 0.5 * a.cell.edges.xx);
  EXPECT_GT(std::abs(b.cell.edges.xy), 0.55 * b.cell.edges.xx);
  EXPECT_EQ(a.contacts.size(), b.contacts.size());
  EXPECT_NEAR(energy(a), energy(b), 1e-10 * energy(b));
  for (std::size_t k = 0; k < a.size(); ++k) EXPECT_LT(norm(a.unwrapped(k) - b.unwrapped(k)), 1e-10);
}

TEST(Flip, TheEnergyIsContinuous) {
  Packing start = tilted_packing(4, 0, 0, 0.54);
  start.order.clear();
  start.step = 0;
  start.cell.rate = {.xy = 0.01};
  const auto simulation = make_simulation(sheared_model(), start);
  simulation->advance(100);
  Observation now(*simulation, 3);
  Flip flip(100);
  ASSERT_TRUE(flip.due(now));
  const double before = energy(now.packing());
  flip.fire(now);
  EXPECT_EQ(flip.count(), 1);
  EXPECT_FALSE(flip.due(now));
  EXPECT_NEAR(energy(now.packing()), before, rounding * before);
}

TEST(Flip, LooksOnceAPeriod) {
  EXPECT_EQ(Flip(100).next(0), 100);
  EXPECT_EQ(Flip(100).next(100), 200);
  EXPECT_EQ(Flip(100).next(199), 200);
}

}  // namespace
}  // namespace furnas
