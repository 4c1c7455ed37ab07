#include "engine/analysis/rattlers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tests/engine/support/graph_packing.h"

namespace furnas {
namespace {

std::vector<bool> all_live(const Packing& p) { return std::vector<bool>(p.contacts.size(), true); }

/// Numbers of the particles that are taken out at a threshold.
std::vector<std::size_t> taken_out(std::size_t particles, const Edges& edges, int least_contacts) {
  const Packing p = packing_of_graph(particles, edges);
  const std::vector<bool> out = rattlers(p, all_live(p), least_contacts);
  std::vector<std::size_t> numbers;
  for (std::size_t k = 0; k < out.size(); ++k)
    if (out[k]) numbers.push_back(k);
  return numbers;
}

using Indices = std::vector<std::size_t>;

Indices all_of(std::size_t particles) {
  Indices numbers;
  for (std::size_t k = 0; k < particles; ++k) numbers.push_back(k);
  return numbers;
}

TEST(Rattlers, AChainFallsApartFromItsEnds) {
  EXPECT_EQ(taken_out(6, chain(6), 1), Indices{});
  EXPECT_EQ(taken_out(6, chain(6), 2), all_of(6));
}

TEST(Rattlers, ARingHoldsAtTwoContacts) {
  const Edges ring = chain(6) + Edges{{5, 0}};
  EXPECT_EQ(taken_out(6, ring, 2), Indices{});
  EXPECT_EQ(taken_out(6, ring, 3), all_of(6));
}

TEST(Rattlers, ATetrahedronHoldsAtThree) {
  for (int least : {2, 3}) EXPECT_EQ(taken_out(4, clique(4), least), Indices{});
  EXPECT_EQ(taken_out(4, clique(4), 4), all_of(4));
}

TEST(Rattlers, WithoutContactsAllRattle) {
  EXPECT_EQ(taken_out(3, {}, 2), all_of(3));
  EXPECT_EQ(taken_out(3, {}, 0), Indices{});
}

/// A particle in a cage touches it at two points or three; the cage stands without it.
TEST(Rattlers, ACagedParticleDoesNotTakeTheCageWithIt) {
  const Edges two = octahedron() + Edges{{0, 6}, {6, 3}};
  EXPECT_EQ(taken_out(7, two, 2), Indices{});
  EXPECT_EQ(taken_out(7, two, 3), Indices{6});
  EXPECT_EQ(taken_out(7, two, 4), Indices{6});
  const Edges three = two + Edges{{6, 4}};
  EXPECT_EQ(taken_out(7, three, 3), Indices{});
  EXPECT_EQ(taken_out(7, three, 4), Indices{6});
}

/// The bridge between two cliques has two contacts a particle; it belongs to the 2-core alone.
TEST(Rattlers, ABridgeBetweenTwoCliquesGoesAtThree) {
  const Edges joined = clique(4) + clique(4, 4) + Edges{{3, 8}, {8, 9}, {9, 4}};
  EXPECT_EQ(taken_out(10, joined, 2), Indices{});
  EXPECT_EQ(taken_out(10, joined, 3), (Indices{8, 9}));
  EXPECT_EQ(taken_out(10, joined, 4), all_of(10));
}

/// Taking one out leaves the next one too few, and so on to the end of a tail on a clique.
TEST(Rattlers, AreTakenOutAgainAndAgain) {
  const Edges tailed = clique(5) + chain(100, 4);
  Indices tail;
  for (std::size_t k = 5; k < 104; ++k) tail.push_back(k);
  for (int least : {2, 3, 4}) EXPECT_EQ(taken_out(104, tailed, least), tail);
}

/// Spheres that meet several images of each other, or their own, touch once for each.
TEST(Rattlers, EveryImageIsAContactOfItsOwn) {
  EXPECT_EQ(taken_out(2, {{0, 1}, {0, 1}, {1, 0}}, 3), Indices{});
  EXPECT_EQ(taken_out(2, {{0, 1}, {0, 1}, {1, 0}}, 4), all_of(2));
  EXPECT_EQ(taken_out(1, {{0, 0}, {0, 0}}, 4), Indices{});
  EXPECT_EQ(taken_out(1, {{0, 0}, {0, 0}}, 5), all_of(1));
}

/// The definition, carried out word for word.
std::vector<bool> slow_rattlers(const Packing& p, const std::vector<bool>& live, int least_contacts) {
  std::vector<bool> out(p.size(), false);
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t k = 0; k < p.size(); ++k) {
      int contacts = 0;
      for (std::size_t n = 0; n < p.contacts.size(); ++n)
        if (const Contact& c = p.contacts[n]; live[n] && !out[c.i] && !out[c.j])
          contacts += (c.i == k) + (c.j == k);
      if (out[k] || contacts >= least_contacts) continue;
      changed = out[k] = true;
    }
  }
  return out;
}

TEST(Rattlers, FollowTheDefinitionOnRandomGraphs) {
  std::mt19937_64 random(1);
  int mixed = 0;
  for (int round = 0; round < 200; ++round) {
    const auto count = static_cast<std::uint32_t>(2 + random() % 40);
    Edges edges;
    for (std::size_t n = 0; n < count * (1 + random() % 4); ++n)
      edges.emplace_back(static_cast<std::uint32_t>(random() % count),
                         static_cast<std::uint32_t>(random() % count));
    const Packing p = packing_of_graph(count, edges);
    std::vector<bool> live = all_live(p);
    for (std::size_t n = 0; n < live.size(); ++n) live[n] = random() % 8 != 0;
    for (int least = 1; least < 6; ++least) {
      const std::vector<bool> out = rattlers(p, live, least);
      EXPECT_EQ(out, slow_rattlers(p, live, least)) << "round " << round << ", threshold " << least;
      mixed += std::count(out.begin(), out.end(), true) % count != 0;
    }
  }
  EXPECT_GT(mixed, 100) << "too few of the graphs have rattlers and a backbone";
}

TEST(CountRattlers, CountsEachSpeciesAndTheBackbone) {
  // A tetrahedron of two large and two small ones, a large and two small ones beside it.
  Packing p = packing_of_graph(7, clique(4) + Edges{{3, 4}, {5, 6}});
  for (std::size_t k : {2, 3, 5, 6}) p.species[k] = Species::small;
  const std::vector<bool> live = all_live(p);
  const RattlerCount three = count_rattlers(p, live, rattlers(p, live, 3), 3);
  EXPECT_EQ(three.least_contacts, 3);
  EXPECT_EQ(three.large, 1);
  EXPECT_EQ(three.small, 2);
  EXPECT_EQ(three.backbone, 4);
  EXPECT_EQ(three.contacts, 6);
  EXPECT_EQ(three.coordination, 3);
  const RattlerCount four = count_rattlers(p, live, rattlers(p, live, 4), 4);
  EXPECT_EQ(four.large, 3);
  EXPECT_EQ(four.small, 4);
  EXPECT_EQ(four.backbone, 0);
  EXPECT_EQ(four.contacts, 0);
  EXPECT_EQ(four.coordination, 0);
}

TEST(LiveContacts, ExceedAShareOfTheMeanOfTheirKind) {
  // Two contacts of each kind; beside the forces between large ones those between small ones are nothing.
  Packing p = packing_of_graph(4, {{0, 1}, {1, 0}, {0, 2}, {3, 1}, {2, 3}, {3, 2}});
  p.species[2] = p.species[3] = Species::small;
  const double forces[] = {1000, 4,   10,
                           0.04, 0.1, 0.0004};  // the second of each pair is below 1 % of the mean
  for (std::size_t n = 0; n < 6; ++n)
    p.contacts[n].force = {forces[n], 50, 0};  // across the normal it is no matter
  EXPECT_EQ(live_contacts(p), (std::vector<bool>{true, false, true, false, true, false}));
  EXPECT_EQ(live_contacts(p, 0), std::vector<bool>(6, true));
}

TEST(LiveContacts, TheShareItselfIsNotEnough) {
  Packing p = packing_of_graph(2, {{0, 1}, {0, 1}});
  const auto second_is_live = [&](double force) -> bool {
    p.contacts[1].force = {force, 0, 0};
    return live_contacts(p, 0.5)[1];
  };
  p.contacts[0].force = {3, 0, 0};  // a force of 1 makes the mean 2
  EXPECT_FALSE(second_is_live(1));
  EXPECT_TRUE(second_is_live(1 + 1e-12));
}

TEST(LiveContacts, AContactThatPullsCarriesNothing) {
  Packing p = packing_of_graph(2, {{0, 1}, {0, 1}, {0, 1}});
  p.contacts[1].force = {-0.5, 0, 0};
  p.contacts[2].force = {0, 1, 0};
  EXPECT_EQ(live_contacts(p, 0), (std::vector<bool>{true, false, false}));
}

/// A tetrahedron with a fifth particle held by three contacts that get fainter.
TEST(RattlerSensitivity, CountsForEveryThresholdOfContactsAndForce) {
  Packing p = packing_of_graph(5, clique(4) + Edges{{4, 0}, {4, 1}, {4, 2}});
  p.species[4] = Species::small;
  // The three contacts are the only large-small ones; their mean is 1.
  p.contacts[6].force = {2.4, 0, 0};
  p.contacts[7].force = {0.55, 0, 0};
  p.contacts[8].force = {0.05, 0, 0};
  const auto rows = rattler_sensitivity(p, {0, 0.1, 0.6});
  ASSERT_EQ(rows.size(), 9U);
  const auto expect = [&](std::size_t row, int least, double share, std::int64_t large, std::int64_t small) {
    EXPECT_EQ(rows[row].count.least_contacts, least) << row;
    EXPECT_EQ(rows[row].share, share) << row;
    EXPECT_EQ(rows[row].count.large, large) << row;
    EXPECT_EQ(rows[row].count.small, small) << row;
  };
  expect(0, 2, 0, 0, 0);
  expect(1, 2, 0.1, 0, 0);
  expect(2, 2, 0.6, 0, 1);
  expect(3, 3, 0, 0, 0);
  expect(4, 3, 0.1, 0, 1);
  expect(5, 3, 0.6, 0, 1);
  for (std::size_t row = 6; row < 9; ++row) expect(row, 4, rows[row].share, 4, 1);
  EXPECT_EQ(rows[4].count.contacts, 6);
}

}  // namespace
}  // namespace furnas
