#include "engine/minimize/enthalpy.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/base/require.h"
#include "engine/trials/crystal.h"
#include "tests/engine/support/dice.h"
#include "tests/engine/support/setups.h"

namespace furnas {
namespace {

constexpr double pressure = 1e-3;
const AnyLaw law = Frictionless<false>{};

Barostat bath(CellFreedom freedom = CellFreedom::triclinic) {
  return {.freedom = freedom, .pressure = pressure};
}

Enthalpy::Point look(Enthalpy& h, const Shift& shift) {
  Enthalpy::Point point(h.particles());
  h.look(shift, point);
  return point;
}

Shift random_shift(test::Dice& dice, std::size_t particles, double size, CellFreedom freedom) {
  Shift shift(particles);
  for (Vec3<double>& u : shift.displacement) u = dice.vector(size);
  const auto e = [&] { return dice.between(-size, size); };
  if (freedom == CellFreedom::triclinic) shift.strain = {e(), e(), e(), e(), e(), e()};
  if (freedom == CellFreedom::orthorhombic) shift.strain = {e(), e(), e(), 0, 0, 0};
  if (freedom == CellFreedom::cubic) shift.strain.xx = shift.strain.yy = shift.strain.zz = e();
  return shift;
}

TEST(EnthalpyOfAPlace, OfTwoSpheresThatOverlap) {
  const Packing p = packing_of(cube(4), {{.position = {1, 1, 1}}, {.position = {1.9, 1, 1}}});
  Enthalpy h(p, law, bath());
  const auto here = look(h, Shift(2));
  EXPECT_NEAR(here.value, 0.5 * 0.1 * 0.1 + pressure * 64, 1e-15);
  EXPECT_NEAR(std::abs(here.gradient.displacement[0].x), 0.1, 1e-15);
  EXPECT_EQ(here.gradient.displacement[0], -here.gradient.displacement[1]);
  EXPECT_NEAR(here.gradient.strain.xx, pressure * 64 - 0.1 * 0.9, 1e-15);
  EXPECT_NEAR(here.gradient.strain.yy, pressure * 64, 1e-15);
  EXPECT_EQ(here.contacts, 1u);
  EXPECT_NEAR(here.mean_force, 0.1, 1e-15);
}

// Its gradient is its derivative, here and at a strained place, in every variable that the cell has. The
// error of a central difference falls with the square of its step, but for contacts that open within it,
// whose energy has a kink in its second derivative.
TEST(EnthalpyOfAPlace, ChangesAsItsGradientSays) {
  test::Dice dice(1);
  const Packing p = squeezed(0);
  for (const CellFreedom freedom :
       {CellFreedom::triclinic, CellFreedom::orthorhombic, CellFreedom::cubic, CellFreedom::fixed}) {
    Enthalpy h(p, law, bath(freedom));
    const Shift away = random_shift(dice, p.size(), 3e-3, freedom);
    ASSERT_TRUE(h.covers(away));
    for (const Shift& from : {Shift(p.size()), away}) {
      const auto point = look(h, from);
      for (int n = 0; n < 5; ++n) {
        const Shift way = random_shift(dice, p.size(), 1, freedom);
        const auto value = [&](double length) {
          Shift there(p.size());
          add(from, length, way, there);
          return look(h, there).value;
        };
        const double step = 1e-6;
        const double slope = (value(step) - value(-step)) / (2 * step);
        EXPECT_NEAR(dot(point.gradient, way), slope,
                    1e-8 * std::sqrt(dot(point.gradient, point.gradient)) * std::sqrt(dot(way, way)));
      }
    }
  }
}

TEST(EnthalpyOfAPlace, HasTheForcesAndTheStressOfAStep) {
  const Packing start = squeezed(0);
  Model model = model_of<Frictionless<false>>({});
  Packing bare = start;
  bare.order.clear();
  const Packing p = with_forces(model, bare);
  Enthalpy h(p, law, bath());
  const auto here = look(h, Shift(p.size()));
  for (std::size_t n = 0; n < p.size(); ++n)
    EXPECT_LT(norm(here.gradient.displacement[n] + p.force[p.order[n]]), 1e-14) << n;
  EXPECT_EQ(here.contacts, p.contacts.size());
  const double outside = pressure * p.cell.volume();
  EXPECT_NEAR(here.gradient.strain.xx, outside - p.stress.contacts(0, 0), 1e-12);
  EXPECT_NEAR(here.gradient.strain.xy, -p.stress.contacts(1, 0), 1e-12);
  EXPECT_NEAR(here.value, elastic_energy(p) + outside, 1e-12);
}

// What a move leads to is what was seen from afar: the place changes, H does not.
TEST(EnthalpyOfAPlace, IsTheSameFromAnotherPlace) {
  test::Dice dice(2);
  const Packing p = squeezed(0);
  Enthalpy h(p, law, bath());
  const Shift way = random_shift(dice, p.size(), 3e-3, CellFreedom::triclinic);
  const auto seen = look(h, way);
  h.move(way);
  const auto there = look(h, Shift(p.size()));
  EXPECT_NEAR(there.value, seen.value, 1e-13 * seen.value);
  EXPECT_EQ(there.contacts, seen.contacts);
  for (std::size_t n = 0; n < p.size(); ++n)
    EXPECT_LT(norm(there.gradient.displacement[n] - seen.gradient.displacement[n]), 1e-13);
}

// The same lattice with other edges is the same packing.
TEST(EnthalpyOfAPlace, DoesNotKnowHowTheLatticeIsDescribed) {
  const Packing p = squeezed(0);
  Packing other = reskewed(p, 1, -1, 1);
  Enthalpy h(p, law, bath());
  Enthalpy g(other, law, bath());
  const auto a = look(h, Shift(p.size()));
  const auto b = look(g, Shift(p.size()));
  EXPECT_NEAR(a.value, b.value, 1e-13 * a.value);
  EXPECT_EQ(a.contacts, b.contacts);
  EXPECT_LT(std::abs(a.gradient.strain.xy - b.gradient.strain.xy), 1e-12);
}

TEST(EnthalpyOfAPlace, PutsBackWhatAStepWouldHave) {
  test::Dice dice(3);
  Packing bare = squeezed(0);
  bare.order.clear();
  const Model model = model_of<Frictionless<false>>({});
  Packing p = with_forces(model, bare);
  Enthalpy h(p, law, bath());
  h.move(random_shift(dice, p.size(), 3e-3, CellFreedom::triclinic));
  h.put_into(p);
  Packing again = p;
  again.order.clear();
  const Packing expected = with_forces(model, again);
  ASSERT_EQ(p.contacts.size(), expected.contacts.size());
  EXPECT_LT(largest_difference(p.force, expected.force), 1e-14);
  EXPECT_LT((p.stress.contacts - expected.stress.contacts).norm(), 1e-12);
  EXPECT_EQ(p.stress.motion, Eigen::Matrix3d::Zero());
  EXPECT_EQ(kinetic_energy(p), 0);
  const auto simulation = make_simulation(model, p);  // every contact is in its list
  EXPECT_EQ(simulation->packing().contacts.size(), p.contacts.size());
  EXPECT_EQ(simulation->packing().fraction, p.fraction);
}

TEST(EnthalpyOfAPlace, IsNotForContactsWithFriction) {
  const Packing p = packing_of(cube(4), {{.position = {1, 1, 1}}});
  EXPECT_THROW(Enthalpy(p, HookeSynchronized{{.friction = 0.3}}, bath()), InputError);
}

}  // namespace
}  // namespace furnas
