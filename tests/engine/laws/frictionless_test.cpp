#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/engine/laws/every_law.h"
#include "tests/engine/support/setups.h"

namespace furnas {
namespace {

template <class Law>
class WithoutFriction : public testing::Test {};
TYPED_TEST_SUITE(WithoutFriction, EveryFrictionLaw, LawName);

/// A packing without what friction left in it, its particles kicked and spinning.
Packing shaken() {
  Packing p = squeezed(1e-3);
  for (Contact& c : p.contacts) c.history = {};
  for (std::size_t k = 0; k < p.size(); ++k) {
    const auto s = static_cast<double>(k);
    p.spin[k] = 1e-2 * Vec3<double>{std::cos(s), std::sin(5 * s), std::cos(7 * s)};
    p.torque[k] = {};
  }
  return p;
}

// T20: mu = 0: spins stay, there is no history, and the scene without friction does the same. The spins stay
// to rounding, not to the bit: n x (F_n n) has a last bit.
TYPED_TEST(WithoutFriction, SpinsStayAndTheLeanSceneAgrees) {
  constexpr int steps = 500;
  const Packing start = shaken();
  const Packing general = after(model_of<TypeParam>({.friction = 0}), start, steps);
  const Packing lean = after(model_of<Frictionless<!TypeParam::synchronized>>({}), start, steps);
  ASSERT_GT(general.contacts.size(), 200u);
  EXPECT_LT(largest_difference(general.spin, start.spin), 1e-15);
  EXPECT_LT(largest_difference(general.velocity, lean.velocity), 1e-13);
  EXPECT_LT(largest_difference(general.force, lean.force), 1e-13);
  EXPECT_EQ(lean.spin, std::vector<Vec3<double>>(start.size()));
  for (const Contact& c : lean.contacts) EXPECT_EQ(c.history, Vec3<double>{});
}

}  // namespace
}  // namespace furnas
