#include "engine/monitor/measure.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/simulation.h"
#include "tests/engine/support/graph_packing.h"

namespace furnas {
namespace {

constexpr double rounding = 1e-13;
constexpr double pi = std::numbers::pi;

/// Two spheres of radii 1/2 and 1 that touch along a slanted branch and move.
Packing two_spheres() {
  Packing p = packing_of_graph(2, {{0, 1}});
  p.step = 40;
  p.time = 2.5;
  p.cell.edges = {4, 5, 6, 0.5, -0.25, 1};
  p.radius = {0.5, 1};
  p.mass = {2, 3};
  p.velocity = {{1, 0, 2}, {0, -1, 0}};
  p.spin = {{0, 3, 0}, {0, 0, 0}};
  Contact& c = p.contacts[0];
  c.branch = {0.6, 0, 0.8};
  c.overlap = 0.5;
  c.force = {3, 1, 4};
  p.force = {c.force, -c.force};
  return p;
}

TEST(Measure, ReadsOffTwoSpheres) {
  const Measures m = measure(two_spheres(), 3);
  EXPECT_EQ(m.step, 40);
  EXPECT_EQ(m.time, 2.5);
  EXPECT_NEAR(m.phi, pi / 6 * (1 + 8) / 120, rounding);
  EXPECT_NEAR(m.kinetic_energy, (0.5 * 2 * 5 + 0.5 * 0.4 * 2 * 0.25 * 9 + 0.5 * 3) / 2, rounding);
  EXPECT_EQ(m.contacts, 1);
  EXPECT_EQ(m.coordination, 1);
  EXPECT_NEAR(m.mean_force, std::sqrt(26.0), rounding);
  EXPECT_EQ(m.largest_overlap, 1);  // of the smaller radius
  EXPECT_EQ(m.sliding_share, 0);
}

// One contact is unloaded when its overlap is gone; damping forces do not count.
TEST(UnloadingStrain, IsThatOfTheSprings) {
  const HookeSynchronized law{{.normal_damping = 5}};
  Packing p = two_spheres();
  EXPECT_NEAR(unloading_strain(p, law), 0.5, rounding);
  p.contacts.push_back(p.contacts[0]);
  p.contacts[1].overlap = 0;  // has just formed, and only its damping pushes
  EXPECT_NEAR(unloading_strain(p, law), 0.25, rounding);
  p.contacts.clear();
  EXPECT_EQ(unloading_strain(p, law), 0);
}

/// P V = branch (x) force + m v (x) v, its symmetric part: with friction the contact exerts a couple.
TEST(Measure, StressIsThatOfContactsAndMotion) {
  const Measures m = measure(two_spheres(), 3);
  const double expected[] = {0.6 * 3 + 2 * 1,  // xx yy zz xy xz yz
                             3 * 1,
                             0.8 * 4 + 2 * 4,
                             (0.6 * 1 + 0 * 3) / 2,
                             (0.6 * 4 + 0.8 * 3) / 2 + 2 * 2,
                             (0 * 4 + 0.8 * 1) / 2};
  for (std::size_t k = 0; k < 6; ++k) EXPECT_NEAR(m.stress[k], expected[k] / 120, rounding) << k;
  EXPECT_NEAR(m.pressure, (expected[0] + expected[1] + expected[2]) / 360, rounding);
}

TEST(Measure, TheBackboneLeavesRattlersOut) {
  // Five spheres that all touch, and one that flies among them and touches one.
  Packing p = packing_of_graph(6, clique(5) + Edges{{0, 5}});
  p.velocity[5] = {100, 0, 0};
  p.force[5] = {0, 7, 0};
  p.velocity[2] = {0, 2, 0};
  p.force[3] = {0, 0, 3};
  for (int threshold : {2, 3, 4}) {
    const Measures m = measure(p, threshold);
    EXPECT_EQ(m.backbone_threshold, threshold);
    EXPECT_NEAR(m.kinetic_energy, (5000.0 + 2) / 6, 1e-10);
    EXPECT_NEAR(m.backbone_kinetic_energy, 2.0 / 5, rounding);
    EXPECT_NEAR(m.force_imbalance, 3.0 / 5 / 1, rounding);
    EXPECT_NEAR(m.coordination, 2 * 11.0 / 6, rounding);
    for (std::size_t n = 0; n < 3; ++n) {
      EXPECT_EQ(m.rattlers[n].least_contacts, static_cast<int>(n) + 2);
      EXPECT_EQ(m.rattlers[n].backbone, 5);
      EXPECT_EQ(m.rattlers[n].large, 1);
      EXPECT_EQ(m.rattlers[n].contacts, 10);
      EXPECT_EQ(m.rattlers[n].coordination, 4);
    }
  }
}

/// The threshold decides whose balance is asked for: a tetrahedron is a backbone at 3 contacts, not at 4.
TEST(Measure, TheBackboneIsThatOfItsThreshold) {
  Packing p = packing_of_graph(4, clique(4));
  p.force[0] = {2, 0, 0};
  EXPECT_NEAR(measure(p, 3).force_imbalance, 0.5, rounding);
  EXPECT_EQ(measure(p, 4).force_imbalance, 0);
  EXPECT_EQ(measure(p, 4).rattlers[2].backbone, 0);
}

TEST(Measure, CountsSlidingContacts) {
  Packing p = packing_of_graph(5, clique(5));
  for (std::size_t n : {0, 3, 4}) p.contacts[n].sliding = true;
  EXPECT_NEAR(measure(p, 3).sliding_share, 0.3, rounding);
}

TEST(Measure, AGasHasNoContactsAndNoNumberIsLost) {
  Packing p = packing_of_graph(3, {});
  p.velocity[0] = {6, 0, 0};
  const Measures m = measure(p, 3);
  EXPECT_EQ(m.contacts, 0);
  EXPECT_EQ(m.coordination, 0);
  EXPECT_EQ(m.mean_force, 0);
  EXPECT_EQ(m.sliding_share, 0);
  EXPECT_EQ(m.force_imbalance, 0);
  EXPECT_EQ(m.backbone_kinetic_energy, 0);
  EXPECT_NEAR(m.kinetic_energy, 6, rounding);
  EXPECT_NEAR(m.pressure, 36.0 / 3000, rounding);
}

/// The forces of a crystal as the engine takes them from its positions.
Packing crystal(const std::vector<Vec3<double>>& basis, double edge, int cells) {
  Packing p;
  const double length = edge * cells;
  p.cell.edges = {length, length, length, 0, 0, 0};
  for (int x = 0; x < cells; ++x)
    for (int y = 0; y < cells; ++y)
      for (int z = 0; z < cells; ++z)
        for (const Vec3<double>& b : basis) {
          p.resize(p.size() + 1);
          p.radius.back() = 0.5;
          p.mass.back() = pi / 6;
          p.fraction.back() = to_fraction({(x + b.x) / cells, (y + b.y) / cells, (z + b.z) / cells});
        }
  Model model;
  model.law = HookeSynchronized{{.friction = 0.3}};
  return make_simulation(model, p)->packing();
}

void expect_crystal(const Packing& p, double distance, double pressure, int contacts_each) {
  const Measures m = measure(p, 4);
  EXPECT_NEAR(m.pressure, pressure, rounding);
  for (std::size_t k = 0; k < 6; ++k) EXPECT_NEAR(m.stress[k], k < 3 ? pressure : 0, rounding) << k;
  EXPECT_EQ(m.coordination, contacts_each);
  EXPECT_NEAR(m.mean_force, 1 - distance, rounding);
  EXPECT_NEAR(m.largest_overlap, 2 * (1 - distance), rounding);
  EXPECT_NEAR(m.phi, static_cast<double>(p.size()) * pi / 6 / p.cell.volume(), rounding);
  EXPECT_LT(m.force_imbalance, 1e-12);
  EXPECT_EQ(m.kinetic_energy, 0);
  EXPECT_EQ(m.rattlers[2].backbone, static_cast<std::int64_t>(p.size()));
  EXPECT_EQ(m.rattlers[2].coordination, contacts_each);
}

/// p = k delta/r^2.
TEST(Measure, ASimpleCubicCrystalHasItsPressure) {
  const double r = 0.98;
  for (int cells : {1, 2, 3}) expect_crystal(crystal({{0, 0, 0}}, r, cells), r, (1 - r) / (r * r), 6);
}

/// p = 2 sqrt(2) k delta/r^2.
TEST(Measure, AFaceCentredCrystalHasItsPressure) {
  const double r = 0.98;
  const std::vector<Vec3<double>> basis{{0, 0, 0}, {0, 0.5, 0.5}, {0.5, 0, 0.5}, {0.5, 0.5, 0}};
  for (int cells : {1, 2})
    expect_crystal(crystal(basis, std::sqrt(2.0) * r, cells), r, 2 * std::sqrt(2.0) * (1 - r) / (r * r), 12);
}

}  // namespace
}  // namespace furnas
