#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "engine/trials/driven.h"
#include "tests/engine/laws/every_law.h"
#include "tests/engine/support/property.h"
#include "tests/engine/support/random_packing.h"
#include "tests/engine/support/setups.h"

namespace furnas {
namespace {

template <class Law>
class Sleep : public testing::Test {};
TYPED_TEST_SUITE(Sleep, EveryLaw, LawName);

/// A lattice of 4^3 spheres at rest, some with velocities of -0, and a few that are shot into it, under the
/// drag of a cell that is sheared.
Packing shooting_gallery(test::Dice& dice) {
  Packing p;
  p.resize(64);
  p.cell.edges = {80, 80, 80, 0, 0, 0};
  p.cell.rate = {dice.between(-0.1, 0.1), dice.between(-0.1, 0.1), dice.between(-0.1, 0.1),
                 dice.between(-0.1, 0.1), dice.between(-0.1, 0.1), dice.between(-0.1, 0.1)};
  for (std::size_t k = 0; k < p.size(); ++k) {
    const auto place = [](std::size_t n) { return std::uint64_t{n} << 59; };
    p.fraction[k] = {place(k % 4), place(k / 4 % 4), place(k / 16)};
    p.radius[k] = 0.9;
    p.mass[k] = sphere_mass(0.9);
    if (dice.chance(0.2)) p.velocity[k] = {-0.0, 0, -0.0};
  }
  for (int shot = 0; shot < 3; ++shot) {
    const std::size_t k = dice.below(64);
    p.velocity[k] = dice.vector(1);
    p.spin[k] = dice.vector(1);
  }
  return p;
}

// What sleeps is what no pass would change: the same bits as where every particle is taken for loaded.
TYPED_TEST(Sleep, ChangesNoBit) {
  int sleepers = 0, woken = 0;
  EXPECT_TRUE(test::holds(20, [&] {
    test::Dice dice(test::any_seed());
    Model model = model_of<TypeParam>({.friction = 0.3});
    model.time_step = 0.1;
    const Packing start = shooting_gallery(dice);
    const auto nothing = [](std::size_t, const Vec3<double>&, double) { return Vec3<double>{}; };
    Driven<TypeParam> engine(model, start, {});
    Driven<TypeParam> awake(model, start, nothing);
    std::ptrdiff_t asleep = 0;
    for (int step = 0; step < 60; ++step) {
      engine.advance(1);
      awake.advance(1);
      const auto& a = engine.state();
      const auto& b = awake.state();
      for (std::size_t k = 0; k < start.size(); ++k) {
        const auto &p = a.particles[k], &q = b.particles[k];
        RC_ASSERT(p.position == q.position);
        RC_ASSERT(std::memcmp(&p.velocity, &q.velocity, sizeof(p.velocity)) == 0);
        if constexpr (TypeParam::spins) RC_ASSERT(std::memcmp(&p.spin, &q.spin, sizeof(p.spin)) == 0);
      }
      RC_ASSERT(a.stress.motion == b.stress.motion);
      const auto& marks = a.contact_state.loaded;
      const auto now = std::count(marks.begin(), marks.end(), std::uint8_t{sleeps});
      sleepers += now > 0;
      woken += now < asleep;
      asleep = now;
    }
  }));
  EXPECT_GT(sleepers, 300) << "of 1200 steps";
  EXPECT_GT(woken, 10);
}

}  // namespace
}  // namespace furnas
