#include "engine/events/quench.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "engine/events/limits.h"
#include "engine/monitor/energy.h"
#include "tests/engine/events/resting_story.h"

namespace furnas {
namespace {

/// Whether the event is due after so many looks at a packing that never changes.
bool due_after(int looks, const Unrest& unrest) {
  RestingStory story([unrest](std::int64_t) { return unrest; });
  story.rests_at(looks - 1);
  story.simulation.advance(story.watch.period(), nullptr);
  return Quench(story.watch).due(story.now);
}

TEST(Quench, WaitsForAWindow) {
  EXPECT_FALSE(due_after(10, {.force_imbalance = 5e-3})) << "the window is full with the eleventh look";
  EXPECT_FALSE(due_after(19, {.force_imbalance = 5e-3}));
  EXPECT_TRUE(due_after(20, {.force_imbalance = 5e-3}));
}

TEST(Quench, IsDueWhenTheBackboneIsNearlyAtRest) {
  const RestCriteria c;
  EXPECT_TRUE(due_after(20, {.force_imbalance = 99 * c.force_imbalance, .rattler_energy = 1}));
  EXPECT_FALSE(due_after(20, {.force_imbalance = 101 * c.force_imbalance}));
  EXPECT_TRUE(due_after(20, {.kinetic_energy = 99 * c.kinetic_energy}));
  EXPECT_FALSE(
      due_after(20, {.force_imbalance = 2 * c.force_imbalance, .kinetic_energy = 101 * c.kinetic_energy}));
  EXPECT_TRUE(due_after(20, {.stress_error = 9.9 * c.stress_error}));
  EXPECT_FALSE(due_after(20, {.stress_error = 10.1 * c.stress_error}));
  EXPECT_FALSE(due_after(20, {.contacts = false}));
}

/// A sphere on two contacts may spin about the line through them for ever. Any energy that upsets no
/// force is of this kind.
TEST(Quench, IsDueWhenNoContactFeelsTheMotion) {
  const RestCriteria c;
  EXPECT_TRUE(due_after(20, {.force_imbalance = 0.9 * c.force_imbalance, .kinetic_energy = 1}));
  EXPECT_FALSE(due_after(20, {.force_imbalance = 1.1 * c.force_imbalance, .kinetic_energy = 1}));
  EXPECT_FALSE(due_after(20, {.stress_error = 1.1 * c.stress_error, .kinetic_energy = 1}));
  RestingStory creeping([](std::int64_t step) {
    return Unrest{.kinetic_energy = 1, .strain = 1.1e-9 * static_cast<double>(step)};
  });
  creeping.rests_at(20);
  EXPECT_FALSE(Quench(creeping.watch).due(creeping.now));
}

TEST(Quench, WaitsForTheCellToSettle) {
  const auto due = [](double drift) {
    RestingStory story(
        [drift](std::int64_t step) { return Unrest{.strain = drift * 1e-5 * static_cast<double>(step)}; });
    story.rests_at(20);
    return Quench(story.watch).due(story.now);
  };
  EXPECT_TRUE(due(99e-6));
  EXPECT_FALSE(due(102e-6));
}

/// How many windows it waits while the forces of a slow packing do not balance; at the end of window
/// `restless` there is a moment of motion, and after window `resumed` another process goes on.
int windows_until_due(int restless = -1, int resumed = -1) {
  const auto length = RestWatch({}).window_length();
  RestingStory story([&](std::int64_t step) {
    return Unrest{.force_imbalance = 0.5, .kinetic_energy = step == restless * length ? 1.0 : 0.0};
  });
  auto quench = std::make_unique<Quench>(story.watch);
  for (int window = 1; window < 100; ++window) {
    for (int k = 0; k < 10; ++k) {
      story.simulation.advance(story.watch.period(), nullptr);
      story.watch.look(story.now);
    }
    if (quench->due(story.now)) return window;
    if (window == resumed) {
      const std::string saved = quench->saved();
      quench = std::make_unique<Quench>(story.watch);
      quench->restore(saved);
    }
  }
  return 0;
}

TEST(Quench, DoesNotWaitForEverForTheForcesToBalance) {
  EXPECT_EQ(windows_until_due(), 51);
  EXPECT_EQ(windows_until_due(5), 53);
  for (int resumed : {1, 4, 11, 52}) EXPECT_EQ(windows_until_due(5, resumed), 53);
}

/// After twenty quenches that brought no rest it lets a swing pass its peak, also in another process.
TEST(Quench, WaitsForThePeakWhereTwentyHaveNotBroughtRest) {
  const auto length = static_cast<std::size_t>(RestWatch({}).window_length());
  const std::vector<double> swing{0, 0, 1, 3, 5, 3, 2, 4};  // window 6 is the first below half of the peak
  const auto first_due = [&](const std::string& before, bool resumed) {
    RestingStory story([&](std::int64_t step) {
      return Unrest{.force_imbalance = 5e-3,
                    .rattler_energy = swing.at(static_cast<std::size_t>(step) / length)};
    });
    auto quench = std::make_unique<Quench>(story.watch);
    quench->restore(before);
    for (int window = 1; window < 8; ++window) {
      for (int k = 0; k < 10; ++k) {
        story.simulation.advance(story.watch.period(), nullptr);
        story.watch.look(story.now);
      }
      if (quench->due(story.now)) return window;
      if (!resumed) continue;
      const std::string saved = quench->saved();
      quench = std::make_unique<Quench>(story.watch);
      quench->restore(saved);
    }
    return 0;
  };
  for (const bool resumed : {false, true}) {
    EXPECT_EQ(first_due("19 1e-4 19 0 0", resumed), 2) << "when the first window is full";
    EXPECT_EQ(first_due("20 1e-4 20 0 0", resumed), 6);
    EXPECT_EQ(first_due("20 1e-4 20 0 3", resumed), 2) << "it is far below its peak";
    EXPECT_EQ(first_due("20 1e-5 20 0 0", resumed), 2) << "another pressure is a new beginning";
  }
}

TEST(Quench, RefusesAMemoryThatIsNone) {
  RestWatch watch({});
  Quench quench(watch);
  quench.restore("");
  quench.restore("2 0.5 1 3 1.5e-5");
  EXPECT_EQ(quench.saved(), "2 0.5 1 3 1.5e-05");
  for (const char* saved : {"2", "2 0.5 1 3", "2 0.5 1 3 ", "2 0.5 1 3 x", "2 0.5 1 3 -1", "2 0.5 1 3 nan",
                            "2 0.5 1 3 4 5", "2 0.5 1 3 4 ", "-1 0.5 1 3 4", "2 -0.5 1 3 4", " "})
    EXPECT_THROW(quench.restore(saved), InputError) << saved;
}

TEST(Quench, TakesOutAllMotionAndNothingElse) {
  RestingStory story([](std::int64_t) { return Unrest{.kinetic_energy = 1e-12, .rattler_energy = 1}; });
  Packing before = story.now.packing();
  before.cell.rate = {1e-3, 2e-3, 3e-3, 4e-3, 5e-3, 6e-3};
  story.now.replace(before);
  double kinetic = 0;
  for (std::size_t k = 0; k < before.size(); ++k) {
    EXPECT_NE(before.spin[k], Vec3<double>{});
    kinetic += kinetic_energy(before, k);
  }
  Quench quench(story.watch);
  quench.fire(story.now);
  EXPECT_EQ(quench.count(), 1);
  const Packing& after = story.now.packing();
  EXPECT_DOUBLE_EQ(after.ledger.quenched, kinetic);
  for (std::size_t k = 0; k < after.size(); ++k) {
    EXPECT_EQ(after.spin[k], Vec3<double>{});
    EXPECT_EQ(after.velocity[k], Vec3<double>{});
  }
  EXPECT_EQ(after.cell.rate, Triangle{});
  EXPECT_EQ(after.cell.edges, before.cell.edges);
  EXPECT_EQ(after.fraction, before.fraction);
  EXPECT_EQ(after.contacts.size(), before.contacts.size());
}

/// It looks when the watch looks, so that it never adds one: a window stays as long as it is.
TEST(Quench, LooksWithTheWatch) {
  for (std::int64_t window : {3, 10, 15, 1005, 10'000}) {
    RestCriteria criteria;
    criteria.window = window;
    RestWatch watch(criteria);
    const Quench quench(watch);
    for (std::int64_t step = quench.next(0), n = 0; n < 5; step = quench.next(step), ++n)
      EXPECT_EQ(step % watch.period(), 0) << "window " << window;
    EXPECT_EQ(quench.next(0), watch.period());
  }
}

}  // namespace
}  // namespace furnas
