#include "engine/events/renew_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "engine/search/size_classes.h"
#include "engine/start/mixture.h"
#include "engine/state/fingerprint.h"

namespace furnas {
namespace {

/// A dense gas with contacts and histories whose particles lie in memory anyhow.
std::unique_ptr<Simulation> disordered() {
  Packing p = dilute_start({.size_ratio = 2, .small_fraction = 0.4, .large = 30, .start_fraction = 0.3});
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> speed(-0.1, 0.1);
  for (auto& v : p.velocity) v = {speed(random), speed(random), speed(random)};
  const double edge = 0.8 * p.cell.edges.xx;
  p.cell.edges = {edge, edge, edge, 0, 0, 0};
  Model model;
  model.law = HookeSynchronized{{.friction = 0.3}};
  model.barostat.freedom = CellFreedom::fixed;
  auto simulation = make_simulation(model, p);
  simulation->advance(20);
  p = simulation->packing();
  // Only within a class of sizes: large ones come first in memory.
  std::shuffle(p.order.begin(), p.order.begin() + 30, random);
  std::shuffle(p.order.begin() + 30, p.order.end(), random);
  simulation->load(p);
  return simulation;
}

TEST(RenewOrder, PutsNeighboursTogetherAndChangesNothing) {
  const auto simulation = disordered();
  Observation now(*simulation, 3);
  const Packing before = now.packing();
  ASSERT_GT(before.contacts.size(), 50u);
  RenewOrder(10).fire(now);
  const Packing& after = now.packing();
  EXPECT_NE(after.order, before.order);
  EXPECT_EQ(after.order, memory_order(before));
  EXPECT_EQ(state_hash(after), state_hash(before));
  EXPECT_EQ(after.time, before.time);
  EXPECT_EQ(after.image, before.image);
  EXPECT_EQ(after.force, before.force);
  EXPECT_EQ(after.torque, before.torque);
  EXPECT_EQ(after.species, before.species);
  EXPECT_EQ(after.stress.contacts, before.stress.contacts);
  EXPECT_EQ(after.stress.motion, before.stress.motion);
}

/// Each contact keeps its force and sliding, whichever of its particles comes first now.
TEST(RenewOrder, KeepsEveryContact) {
  const auto simulation = disordered();
  Observation now(*simulation, 3);
  const auto sorted = [](std::vector<Contact> contacts) {
    for (Contact& c : contacts)
      if (c.i > c.j) std::swap(c.i, c.j), c.branch = -c.branch, c.force = -c.force, c.history = -c.history;
    std::sort(contacts.begin(), contacts.end(),
              [](const Contact& a, const Contact& b) { return std::pair(a.i, a.j) < std::pair(b.i, b.j); });
    return contacts;
  };
  const std::vector<Contact> before = sorted(now.packing().contacts);
  RenewOrder(10).fire(now);
  const std::vector<Contact> after = sorted(now.packing().contacts);
  ASSERT_EQ(after.size(), before.size());
  int slid = 0;
  for (std::size_t n = 0; n < after.size(); ++n) {
    EXPECT_EQ(after[n].i, before[n].i);
    EXPECT_EQ(after[n].j, before[n].j);
    EXPECT_EQ(after[n].branch, before[n].branch);
    EXPECT_EQ(after[n].overlap, before[n].overlap);
    EXPECT_EQ(after[n].force, before[n].force);
    EXPECT_EQ(after[n].history, before[n].history);
    EXPECT_EQ(after[n].sliding, before[n].sliding);
    slid += before[n].history != Vec3<double>{};
  }
  EXPECT_GT(slid, 50);
}

TEST(RenewOrder, HappensAtMultiplesOfItsPeriod) {
  EXPECT_EQ(RenewOrder(300).next(0), 300);
  EXPECT_EQ(RenewOrder(300).next(301), 600);
}

}  // namespace
}  // namespace furnas
