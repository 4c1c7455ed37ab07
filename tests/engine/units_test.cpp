#include <gtest/gtest.h>

#include <cmath>

#include "engine/monitor/measure.h"
#include "tests/engine/laws/every_law.h"
#include "tests/engine/support/compaction.h"
#include "tests/engine/support/same_packing.h"
#include "tests/engine/support/setups.h"
#include "tests/engine/support/symmetries.h"

namespace furnas {
namespace {

using test::in_units;
using test::Units;

constexpr Units every_unit[] = {{7, 0}, {-9, 0}, {0, 12}, {0, -8}, {-20, 30}, {33, -14}};

template <class Law>
class UnitsOfMeasure : public testing::Test {};
TYPED_TEST_SUITE(UnitsOfMeasure, EveryLaw, LawName);

/// Steps the model and the same in other units: no bit may differ but those of the exponents. Nor may the
/// number of neighbour lists, which tells whether a skin was chosen by an absolute length.
void expect_the_same_in_any_units(const Model& model, const Packing& start, int steps) {
  const auto run = [steps](const Model& m, const Packing& p) {
    auto simulation = make_simulation(m, p);
    simulation->advance(steps);
    return simulation;
  };
  const auto one = run(model, start);
  for (const Units& units : every_unit) {
    const auto other = run(in_units(model, units), in_units(start, units));
    EXPECT_TRUE(test::same_state(other->packing(), in_units(one->packing(), units)))
        << units.length << ' ' << units.mass;
    EXPECT_EQ(other->neighbours().builds, one->neighbours().builds);
  }
}

// T30: a gas that is squeezed until it touches everywhere, in a cell that moves.
TYPED_TEST(UnitsOfMeasure, LeaveAGasAlone) {
  Model model = test::hasty_model(0.3);
  model.law = TypeParam{{.friction = 0.3}};
  const Packing gas = test::hasty_gas(3);
  expect_the_same_in_any_units(model, gas, 700);
  const Packing end = after(model, gas, 700);
  EXPECT_GT(end.contacts.size(), 200u);
  EXPECT_GT(std::abs(end.cell.edges.xy), 1e-3);
}

// T30: a packing with histories, with the drag of the cell, without attraction and with a skin of its own.
TYPED_TEST(UnitsOfMeasure, LeaveAPackingAlone) {
  Model model = model_of<TypeParam>({.tangential_stiffness = 0.7, .friction = 0.3, .attraction = false});
  model.barostat = {.pressure = 1e-3, .inertia = 5000, .drag = 0.1};
  model.affine_velocity = true;
  expect_the_same_in_any_units(model, squeezed(1e-2), 200);
  model.skin = 0.03;
  expect_the_same_in_any_units(model, squeezed(1e-2), 200);
}

// T30: what is read off a packing.
TEST(UnitsOfMeasure, LeaveMeasuresAlone) {
  const Packing p = after(jammed_model(), jammed(), 200);
  const Measures m = measure(p, 3);
  ASSERT_GT(m.sliding_share, 0);
  ASSERT_GT(m.rattlers[1].small, 0);
  for (const Units& units : every_unit) {
    const Measures n = measure(in_units(p, units), 3);
    const double length = std::ldexp(1.0, units.length);
    EXPECT_EQ(n.phi, m.phi);
    EXPECT_EQ(n.pressure * length, m.pressure);
    EXPECT_EQ(n.kinetic_energy, m.kinetic_energy * length * length);
    EXPECT_EQ(n.backbone_kinetic_energy, m.backbone_kinetic_energy * length * length);
    EXPECT_EQ(n.force_imbalance, m.force_imbalance);
    EXPECT_EQ(n.largest_overlap, m.largest_overlap);
    EXPECT_EQ(n.coordination, m.coordination);
    EXPECT_EQ(n.sliding_share, m.sliding_share);
    for (std::size_t z = 0; z < m.rattlers.size(); ++z) {
      EXPECT_EQ(n.rattlers[z].small, m.rattlers[z].small);
      EXPECT_EQ(n.rattlers[z].large, m.rattlers[z].large);
      EXPECT_EQ(n.rattlers[z].contacts, m.rattlers[z].contacts);
    }
  }
}

}  // namespace
}  // namespace furnas
