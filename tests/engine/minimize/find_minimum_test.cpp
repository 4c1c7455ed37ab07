#include "engine/minimize/find_minimum.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/base/parallel.h"
#include "engine/start/mixture.h"
#include "engine/trials/crystal.h"
#include "tests/engine/support/dice.h"
#include "tests/engine/support/same_packing.h"
#include "tests/engine/support/setups.h"

namespace furnas {
namespace {

const AnyLaw frictionless = Frictionless<false>{};
constexpr std::int64_t plenty = 20'000;

/// The packing at its minimum.
Packing at_rest(Packing p, const Barostat& bath, const MinimumCriteria& criteria = {}) {
  Enthalpy h(p, frictionless, bath);
  const MinimumReport report = find_minimum(h, plenty, criteria);
  EXPECT_TRUE(report.reached);
  EXPECT_LT(report.evaluations, plenty);
  h.put_into(p);
  return p;
}

Packing shaken(Packing p, double size, const Triangle& strain) {
  test::Dice dice(4);
  for (Fraction& s : p.fraction) {
    const Vec3<double> moved = in_unit_cell(s) + inverse(p.cell.edges) * dice.vector(size);
    s = to_fraction(moved);
  }
  p.cell.edges += product(strain, p.cell.edges);
  return p;
}

// Two spheres as in caesium chloride, each on 8 contacts of the length sqrt(3)/2 L:
// H = 4 (1 - sqrt(3)/2 L)^2 + p L^3 is least where 3 p L^2 + 6 L - 4 sqrt(3) = 0.
TEST(FindMinimum, OfTwoSpheresInACell) {
  constexpr double pressure = 0.01;
  const Packing start =
      packing_of(cube(1.14), {{.position = {0.01, 0, 0}}, {.position = {0.57, 0.57, 0.56}}});
  const Packing p = at_rest(start, {.freedom = CellFreedom::cubic, .pressure = pressure});
  const double length = (std::sqrt(36 + 48 * std::sqrt(3.0) * pressure) - 6) / (6 * pressure);
  EXPECT_NEAR(p.cell.edges.xx, length, 1e-9);
  EXPECT_EQ(p.cell.edges.xx, p.cell.edges.yy);
  EXPECT_EQ(p.cell.edges.xy, 0);
  EXPECT_EQ(p.contacts.size(), 8u);
  const Vec3<double> apart = nearest_difference(p.fraction[0], p.fraction[1]);
  EXPECT_NEAR(std::abs(apart.x), 0.5, 1e-9);
}

// A face-centred crystal has 6 contacts a sphere and V = r^3/sqrt 2 for each, so p = 2 sqrt 2 (1 - r)/r^2.
TEST(FindMinimum, OfAShakenAndStrainedCrystal) {
  constexpr double pressure = 1e-3;
  const double q = pressure / (2 * std::sqrt(2));
  const double r = (std::sqrt(1 + 4 * q) - 1) / (2 * q);
  const Packing start = shaken(face_centred(0.998, 4), 1e-3, {2e-3, -1e-3, 0, 3e-3, -2e-3, 1e-3});
  const Packing p = at_rest(start, {.pressure = pressure});
  EXPECT_EQ(p.contacts.size(), 6 * p.size());
  for (const Contact& c : p.contacts) ASSERT_NEAR(norm(c.branch), r, 1e-9);
  EXPECT_NEAR(p.cell.volume(), static_cast<double>(p.size()) * r * r * r / std::sqrt(2), 1e-6);
  EXPECT_NEAR(contact_pressure(p), pressure, 1e-7 * pressure);
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < a; ++b)
      EXPECT_LT(std::abs(p.stress.contacts(a, b)) / p.cell.volume(), 1e-7 * pressure);
}

// A simple cubic crystal gives way to shear, but its cell may not: p = (1 - r)/r^2.
TEST(FindMinimum, OfASimpleCubicCrystal) {
  constexpr double pressure = 1e-3;
  const Packing start = shaken(simple_cubic(0.999, 3), 0, {1e-3, -1e-3, 2e-3, 0, 0, 0});
  const Packing p = at_rest(start, {.freedom = CellFreedom::orthorhombic, .pressure = pressure});
  const double r = (std::sqrt(1 + 4 * pressure) - 1) / (2 * pressure);
  for (double edge : {p.cell.edges.xx, p.cell.edges.yy, p.cell.edges.zz}) EXPECT_NEAR(edge, 3 * r, 1e-9);
  EXPECT_EQ(p.cell.edges.xy, 0);
}

// In a chain that closes through the cell every contact bears the same force, whatever its spheres' sizes.
TEST(FindMinimum, OfAChain) {
  std::vector<Ball> balls;
  double x = 0.02;
  for (double radius : {0.5, 1.5, 0.7, 0.5, 0.9, 0.5}) {
    balls.push_back({.position = {x + radius + 0.01 * radius * radius, 5, 5}, .radius = radius});
    x += 2 * radius;
  }
  const double shortened = 0.06;  // shared by six contacts
  const Packing p = at_rest(packing_of({2 * 4.6 - shortened, 10, 10, 0, 0, 0}, balls),
                            {.freedom = CellFreedom::fixed, .pressure = 1e-4});
  ASSERT_EQ(p.contacts.size(), 6u);
  for (const Contact& c : p.contacts) EXPECT_NEAR(c.overlap, shortened / 6, 1e-9);
}

/// 1500 spheres in a disordered heap, squeezed until they overlap.
Packing heap() {
  Packing p = dilute_start({.large = 1500, .start_fraction = 0.3, .seed = 2});
  const double s = std::cbrt(0.3 / 0.66);
  p.cell.edges = product({s, s, s, 0, 0, 0}, p.cell.edges);
  p.order = {};
  return p;
}

TEST(FindMinimum, HasTheSameBitsForAnyThreads) {
  const auto end = [](int threads) {
    Packing p = heap();
    MinimumReport report;
    Workers(threads).run([&] {
      Enthalpy h(p, frictionless, {.pressure = 1e-2});
      report = find_minimum(h, 300);
      h.put_into(p);
    });
    EXPECT_EQ(report.evaluations, 300);
    EXPECT_FALSE(report.reached);
    return p;
  };
  const Packing one = end(1);
  for (int threads : {2, 3}) EXPECT_TRUE(test::same_packing(end(threads), one)) << threads;
}

TEST(FindMinimum, LeavesForcesAndMomentumBalanced) {
  const Packing p = at_rest(heap(), {.pressure = 1e-2});
  double mean = 0, imbalance = 0;
  Vec3<double> sum;
  for (const Contact& c : p.contacts) mean += norm(c.force) / static_cast<double>(p.contacts.size());
  for (const Vec3<double>& f : p.force) imbalance += norm(f) / static_cast<double>(p.size()), sum += f;
  EXPECT_LT(imbalance, 1e-8 * mean);
  EXPECT_LT(norm(sum), 1e-12);
  EXPECT_NEAR(contact_pressure(p), 1e-2, 1e-9);
}

// The way down does not depend on the axes that describe the lattice.
TEST(FindMinimum, IsTheSameInAReskewedCell) {
  const Packing start = shaken(face_centred(0.998, 3), 1e-3, {1e-3, 0, 0, 0, 0, 1e-3});
  const Packing a = at_rest(start, {.pressure = 1e-3});
  const Packing b = at_rest(reskewed(start, 0, 1, 0), {.pressure = 1e-3});
  EXPECT_NEAR(a.cell.volume(), b.cell.volume(), 1e-8);
  EXPECT_EQ(a.contacts.size(), b.contacts.size());
}

}  // namespace
}  // namespace furnas
