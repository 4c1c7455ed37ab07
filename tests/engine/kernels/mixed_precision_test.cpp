#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/engine/support/compaction.h"
#include "tests/engine/support/setups.h"

namespace furnas {
namespace {

/// Both precisions from the same state, after some steps.
struct Both {
  Packing mixed, full;
};

Both both_after(Model model, const Packing& start, std::int64_t steps) {
  Both both;
  model.precision = Precision::mixed;
  both.mixed = after(model, start, steps);
  model.precision = Precision::full;
  both.full = after(model, start, steps);
  return both;
}

/// A packing that single precision represents exactly: what differs later was computed.
Packing representable(Packing p) {
  const auto narrow = [](double x) { return static_cast<double>(static_cast<float>(x)); };
  const auto each = [&](Vec3<double>& v) { v = {narrow(v.x), narrow(v.y), narrow(v.z)}; };
  for (auto& v : p.velocity) each(v);
  for (auto& w : p.spin) each(w);
  for (double& r : p.radius) r = narrow(r);
  for (double& m : p.mass) m = 1 / narrow(1 / m);
  return p;
}

/// Share by which the forces of contacts differ; their number must not.
double difference_of_forces(const Both& both) {
  EXPECT_EQ(both.mixed.contacts.size(), both.full.contacts.size());
  double difference = 0;
  double all = 0;
  for (std::size_t n = 0; n < both.full.contacts.size(); ++n) {
    EXPECT_EQ(both.mixed.contacts[n].j, both.full.contacts[n].j);
    difference += norm(both.mixed.contacts[n].force - both.full.contacts[n].force);
    all += norm(both.full.contacts[n].force);
  }
  return difference / all;
}

/// One rounding of `float`.
constexpr double rounding = 0x1p-24;

class MixedPrecision : public testing::TestWithParam<double> {
 protected:
  const Model model = [] {
    Model m = jammed_model();
    m.barostat.freedom = CellFreedom::triclinic;
    m.barostat.pressure = 1e-4;
    m.barostat.inertia = 1e4;
    if (GetParam() == 0) m.law = Frictionless<false>{{}};
    return m;
  }();
  const Packing start = [] {
    Packing p = representable(jammed());
    p.order.clear();  // forces are taken anew
    return p;
  }();
};

// The contacts are the same, for overlaps are of double precision; a force is wrong by a few roundings of
// `float`.
TEST_P(MixedPrecision, FindsTheContactsAndForcesOfDoublePrecision) {
  const Both both = both_after(model, start, 0);
  ASSERT_GT(both.full.contacts.size(), 200u);
  EXPECT_LT(difference_of_forces(both), 4 * rounding);
  EXPECT_GT(difference_of_forces(both), 0);  // it is another precision
  for (std::size_t n = 0; n < both.full.contacts.size(); ++n)
    EXPECT_NEAR(both.mixed.contacts[n].overlap, both.full.contacts[n].overlap, 1e-13);
}

// Positions move in double precision: a speed of 1e-9 still moves a particle.
TEST_P(MixedPrecision, MovesWhatIsNearlyAtRest) {
  Packing p = alone({{.velocity = {1e-9, -2e-9, 3e-12}}});
  Model free = model;
  free.precision = Precision::mixed;
  free.barostat.freedom = CellFreedom::fixed;
  constexpr int steps = 1000;
  const Packing end = after(free, p, steps);
  const Vec3<double> moved = end.unwrapped(0) - p.unwrapped(0);
  const double time = steps * free.time_step;
  EXPECT_NEAR(moved.x, 1e-9 * time, 1e-6 * 1e-9 * time);
  EXPECT_NEAR(moved.y, -2e-9 * time, 1e-6 * 2e-9 * time);
  EXPECT_NEAR(moved.z, 3e-12 * time, 2e-13);  // its rounding in a cell of 128 is 2^-46
}

// Over some steps of a packing the two stay together: a rounding a step, ten times grown between touching
// spheres.
TEST_P(MixedPrecision, StaysWithDoublePrecisionAtFirst) {
  constexpr int steps = 200;
  const Both both = both_after(model, start, steps);
  double fastest = 0;
  for (const Vec3<double>& v : both.full.velocity) fastest = std::max(fastest, norm(v));
  EXPECT_LT(largest_difference(both.mixed.velocity, both.full.velocity), 10 * steps * rounding * fastest);
  EXPECT_LT(std::abs(both.mixed.cell.edges.xx / both.full.cell.edges.xx - 1), 10 * steps * rounding);
}

INSTANTIATE_TEST_SUITE_P(Friction, MixedPrecision, testing::Values(0.0, 0.3));

}  // namespace
}  // namespace furnas
