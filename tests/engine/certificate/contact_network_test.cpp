#include "engine/certificate/contact_network.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/certificate/statics.h"
#include "engine/trials/crystal.h"
#include "tests/engine/support/setups.h"

namespace furnas {
namespace {

const Springs rough{.law = HookeSynchronized{{.friction = 0.3}}};

TEST(ContactNetwork, HasTheForcesOfAPackingAtRest) {
  const Packing& p = jammed();
  const ContactNetwork network = contact_network(p, rough);
  ASSERT_EQ(network.contacts.size(), p.contacts.size());
  EXPECT_EQ(network.unlisted, 0);
  EXPECT_EQ(network.open, 0);
  std::size_t rubbing = 0;
  for (const StaticContact& c : network.contacts) {
    EXPECT_TRUE(c.known);
    EXPECT_GT(c.normal_force, 0);
    EXPECT_LT(std::abs(dot(c.normal, c.tangential_force)), 1e-15);
    rubbing += norm(c.tangential_force) > 0.01 * network.mean_force;
  }
  EXPECT_GT(rubbing, network.contacts.size() / 2);
}

// Without motion and friction the engine's own stress is that of the springs. 1e-11: overlaps are some 1e-4
// of the branches that they are rounded with.
TEST(ContactNetwork, HasTheStressOfSpheresThatDoNotMove) {
  Packing still = jammed();
  still.contacts.clear(), still.order.clear();
  std::fill(still.velocity.begin(), still.velocity.end(), Vec3<double>{});
  const Eigen::Matrix3d expected =
      with_forces(model_of<Frictionless<false>>({}), still).stress.contacts / still.cell.volume();
  const Eigen::Matrix3d stress = static_stress(contact_network(jammed(), {}));
  EXPECT_LT((stress - expected).norm(), 1e-11 * expected.norm());
}

// Neither the order of the two particles, nor the choice of the lattice's edges, nor the branch, force and
// overlap that the list holds say anything.
TEST(ContactNetwork, ReadsHistoriesAlone) {
  const Packing& p = jammed();
  const auto expected = contact_network(p, rough);
  Packing other = reskewed(p, 1, -1, 0);
  for (std::size_t n = 0; n < other.contacts.size(); ++n) {
    Contact& c = other.contacts[n];
    if (n % 2 == 0 && c.i != c.j) {
      std::swap(c.i, c.j);
      c.history = -c.history;
      for (auto& cells : c.image) cells = static_cast<std::int8_t>(-cells);
    }
    c.branch = {}, c.force = {}, c.overlap = NAN;
  }
  for (auto& f : other.force) f = {NAN, NAN, NAN};
  for (auto& v : other.velocity) v = {NAN, NAN, NAN};
  const auto found = contact_network(other, rough);
  EXPECT_EQ(found.unlisted, 0);
  // The other edges round differently, in the sixteenth digit of a branch; overlaps are some 1e-3 of it.
  EXPECT_LT((static_stress(found) - static_stress(expected)).norm(), 1e-11 * static_stress(expected).norm());
  EXPECT_NEAR(found.mean_force, expected.mean_force, 1e-11 * expected.mean_force);
}

TEST(ContactNetwork, CountsWhereTheListIsWrong) {
  Packing p = jammed();
  const Contact lost = p.contacts.back();
  p.contacts.pop_back();
  ContactNetwork network = contact_network(p, rough);
  EXPECT_EQ(network.unlisted, 1);
  EXPECT_EQ(network.open, 0);
  p = jammed();
  p.radius[lost.i] *= 0.9;
  network = contact_network(p, rough);
  EXPECT_EQ(network.unlisted, 0);
  EXPECT_GT(network.open, 0);
}

// A sphere that touches its own images has a history with each of them.
TEST(ContactNetwork, TellsImagesApart) {
  Packing p = simple_cubic(0.95, 1);
  for (int axis = 0; axis < 3; ++axis) {
    Contact c;
    c.image[static_cast<std::size_t>(axis)] = 1;
    const double size = 1e-4 * (axis + 1);
    c.history = axis == 0   ? Vec3<double>{0, size, 0}
                : axis == 1 ? Vec3<double>{0, 0, size}
                            : Vec3<double>{size, 0, 0};
    p.contacts.push_back(c);
  }
  const ContactNetwork network = contact_network(p, rough);
  ASSERT_EQ(network.contacts.size(), 3u);
  EXPECT_EQ(network.unlisted, 0);
  for (const StaticContact& c : network.contacts) {
    const double axis = std::abs(c.normal.y) + 2 * std::abs(c.normal.z);
    EXPECT_NEAR(norm(c.tangential_force), 1e-4 * (axis + 1), 1e-16);
  }
}

// Simple cubic: p = k delta/r^2 along each axis; face-centred cubic: p = 2 sqrt 2 k delta/r^2 (T35).
TEST(StaticStress, OfCrystals) {
  constexpr double r = 0.95;
  const auto expect = [](const Packing& crystal, double pressure) {
    const Eigen::Matrix3d stress = static_stress(contact_network(crystal, {}));
    EXPECT_LT((stress - pressure * Eigen::Matrix3d::Identity()).norm(), 1e-13 * pressure);
  };
  for (int cells : {1, 2, 3}) {
    expect(simple_cubic(r, cells), (1 - r) / (r * r));
    expect(face_centred(r, cells), 2 * std::sqrt(2) * (1 - r) / (r * r));
  }
  expect(reskewed(face_centred_primitive(r), 1, -1, 2), 2 * std::sqrt(2) * (1 - r) / (r * r));
}

// A sphere of a simple cubic crystal, out of its place by x along an edge, is pushed back by 2 k x, and away
// by the four contacts across, which have turned by x/r; its neighbours get the opposite. For equal spheres
// that touch, the load is the mean contact force; were they four times as large under the same pressure, it
// would be p pi R^2.
TEST(Imbalance, IsThatOfAnyOneParticleOverItsLoad) {
  constexpr double r = 0.95;
  constexpr double f = 1 - r;
  constexpr double x = 1e-6;
  Packing p = simple_cubic(r, 3);
  p.fraction[13].x += to_fixed(x / p.cell.edges.xx);
  ContactNetwork network = contact_network(p, {});
  const Backbone all = find_backbone(network, p.species, {.force_share = 0, .least_contacts = 4});
  ASSERT_EQ(all.particles.size(), 27u);
  const double largest = (2 - 4 * f / r) * x;
  const double mean = 4 * x / 27;
  // 1e-5: overlaps change to second order in x/r.
  const auto expect = [&](double load) {
    const Imbalance found = imbalance(network, all);
    EXPECT_NEAR(found.largest_force, largest / load, 1e-5 * largest / load);
    EXPECT_NEAR(found.mean_force, mean / f, 1e-5 * mean / f);
  };
  expect(f);
  for (double& radius : network.radius) radius *= 4;
  expect(f / (r * r) * std::numbers::pi * 4);
}

}  // namespace
}  // namespace furnas
