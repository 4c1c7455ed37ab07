#include "engine/events/still_rattlers.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/analysis/energy.h"
#include "engine/events/limits.h"
#include "tests/engine/events/resting_story.h"

namespace furnas {
namespace {

/// Whether the event is due after so many looks at a packing that never changes.
bool due_after(int looks, const Unrest& unrest) {
  RestingStory story([unrest](std::int64_t) { return unrest; });
  story.rests_at(looks - 1);
  story.simulation.advance(story.watch.period(), nullptr);
  return StillRattlers(story.watch).due(story.now);
}

TEST(StillRattlers, WaitsForAWindow) {
  EXPECT_FALSE(due_after(10, {.force_imbalance = 5e-3}));
  EXPECT_TRUE(due_after(11, {.force_imbalance = 5e-3}));
}

TEST(StillRattlers, IsDueWhenTheBackboneIsNearlyAtRest) {
  const RestCriteria c;
  EXPECT_TRUE(due_after(11, {.force_imbalance = 99 * c.force_imbalance, .rattler_energy = 1}));
  EXPECT_FALSE(due_after(11, {.force_imbalance = 101 * c.force_imbalance}));
  EXPECT_TRUE(due_after(11, {.kinetic_energy = 0.99 * c.kinetic_energy}));
  EXPECT_FALSE(due_after(11, {.kinetic_energy = 1.01 * c.kinetic_energy}));
  EXPECT_TRUE(due_after(11, {.stress_error = 0.99 * c.stress_error}));
  EXPECT_FALSE(due_after(11, {.stress_error = 1.01 * c.stress_error}));
  EXPECT_FALSE(due_after(11, {.contacts = false}));
}

TEST(StillRattlers, WaitsForTheCellToSettle) {
  const auto due = [](double drift) {
    RestingStory story(
        [drift](std::int64_t step) { return Unrest{.strain = drift * 1e-5 * static_cast<double>(step)}; });
    story.rests_at(11);
    return StillRattlers(story.watch).due(story.now);
  };
  EXPECT_TRUE(due(99e-6));
  EXPECT_FALSE(due(102e-6));
}

TEST(StillRattlers, StopsTheRattlersAndNothingElse) {
  RestingStory story([](std::int64_t) { return Unrest{.kinetic_energy = 1e-12, .rattler_energy = 1}; });
  const Packing before = story.now.packing();
  StillRattlers still(story.watch);
  still.fire(story.now);
  EXPECT_EQ(still.count(), 1);
  EXPECT_EQ(story.now.packing().ledger.stilled, kinetic_energy(before, 5));
  const Packing& after = story.now.packing();
  EXPECT_NE(before.spin[5], Vec3<double>{});
  EXPECT_EQ(after.spin[5], Vec3<double>{});
  EXPECT_EQ(after.velocity[5], Vec3<double>{});
  for (std::size_t k = 0; k < 5; ++k) {
    EXPECT_EQ(after.spin[k], before.spin[k]);
    EXPECT_NE(after.spin[k], Vec3<double>{});
  }
  EXPECT_EQ(after.fraction, before.fraction);
  EXPECT_EQ(after.contacts.size(), before.contacts.size());
}

/// It looks when the watch looks, so that it never adds one: a window stays as long as it is.
TEST(StillRattlers, LooksWithTheWatch) {
  for (std::int64_t window : {3, 10, 15, 1005, 10'000}) {
    RestCriteria criteria;
    criteria.window = window;
    RestWatch watch(criteria);
    const StillRattlers still(watch);
    for (std::int64_t step = still.next(0), n = 0; n < 5; step = still.next(step), ++n)
      EXPECT_EQ(step % watch.period(), 0) << "window " << window;
    EXPECT_EQ(still.next(0), 10 * watch.period());
  }
}

}  // namespace
}  // namespace furnas
