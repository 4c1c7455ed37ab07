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

/// The look at which the event is first due, from 1 on; 0 if it never is. After look `resumed` another
/// process goes on.
int first_due(RestingStory& story, int looks = 40, int resumed = 0) {
  auto quench = std::make_unique<Quench>(story.watch);
  for (int look = 1; look <= looks; ++look) {
    story.simulation.advance(story.watch.period(), nullptr);
    if (quench->due(story.now)) return look;
    if (look != resumed) continue;
    const std::string saved = quench->saved();
    quench = std::make_unique<Quench>(story.watch);
    quench->restore(saved);
  }
  return 0;
}

/// The same for a packing that never changes.
int first_due(const Unrest& unrest, const RestCriteria& criteria = {}, int looks = 40) {
  RestingStory story([unrest](std::int64_t) { return unrest; }, criteria);
  return first_due(story, looks);
}

/// The first end of a window at which the drift over a window is known: it takes eleven looks.
constexpr int second_window = 20;

TEST(Quench, IsDueWhenTheBackboneIsNearlyAtRest) {
  const RestCriteria c;
  EXPECT_EQ(first_due({.force_imbalance = 99 * c.force_imbalance, .rattler_energy = 1}), second_window);
  EXPECT_EQ(first_due({.force_imbalance = 101 * c.force_imbalance}), 0);
  EXPECT_EQ(first_due({.force_imbalance = 2 * c.force_imbalance, .kinetic_energy = 9.9e3 * c.kinetic_energy}),
            second_window);
  EXPECT_EQ(
      first_due({.force_imbalance = 2 * c.force_imbalance, .kinetic_energy = 1.01e4 * c.kinetic_energy}), 0);
  EXPECT_EQ(first_due({.stress_error = 9.9 * c.stress_error}), second_window);
  EXPECT_EQ(first_due({.stress_error = 10.1 * c.stress_error}), 0);
  EXPECT_EQ(first_due({.contacts = false}), 0);
}

TEST(Quench, IsDueAsNearToRestAsTheCriteriaSay) {
  const RestCriteria c;
  EXPECT_EQ(first_due({.force_imbalance = 9 * c.force_imbalance}, {.stilling = 10}), second_window);
  EXPECT_EQ(first_due({.force_imbalance = 11 * c.force_imbalance}, {.stilling = 10}), 0);
  const Unrest warm{.force_imbalance = 2 * c.force_imbalance, .kinetic_energy = 99 * c.kinetic_energy};
  EXPECT_EQ(first_due(warm, {.stilling_energy = 100}), second_window);
  EXPECT_EQ(first_due(warm, {.stilling_energy = 98}), 0);
  EXPECT_EQ(first_due({}, {.stilling = 0}, 600), 0) << "never";
}

/// A sphere on two contacts may spin about the line through them for ever. Any energy that upsets no
/// force is of this kind.
TEST(Quench, IsDueWhenNoContactFeelsTheMotion) {
  const RestCriteria c;
  EXPECT_EQ(first_due({.force_imbalance = 0.9 * c.force_imbalance, .kinetic_energy = 1}), second_window);
  EXPECT_EQ(first_due({.force_imbalance = 1.1 * c.force_imbalance, .kinetic_energy = 1}), 0);
  EXPECT_EQ(first_due({.stress_error = 1.1 * c.stress_error, .kinetic_energy = 1}), 0);
  RestingStory creeping([](std::int64_t step) {
    return Unrest{.kinetic_energy = 1, .strain = 1.1e-9 * static_cast<double>(step)};
  });
  EXPECT_EQ(first_due(creeping), 0);
}

TEST(Quench, WaitsForTheCellToSettle) {
  const auto due = [](double drift) {
    RestingStory story(
        [drift](std::int64_t step) { return Unrest{.strain = drift * 1e-5 * static_cast<double>(step)}; });
    return first_due(story);
  };
  EXPECT_EQ(due(99e-6), second_window);
  EXPECT_EQ(due(102e-6), 0);
}

/// The backbone of a packing that is unstable, whose energy grows by a factor in each window, until it falls
/// back to the first value when contacts give way after 60 looks.
int due_of_unstable(double growth, int resumed = 0) {
  RestingStory story([growth](std::int64_t step) {
    const double windows = static_cast<double>(step) / 10'000;
    const double energy = 1e-11 * (windows > 6 ? 1 : std::pow(growth, windows));
    return Unrest{.force_imbalance = 5e-3, .kinetic_energy = energy};
  });
  return first_due(story, 100, resumed);
}

TEST(Quench, LetsMotionOfTheBackboneGrow) {
  EXPECT_EQ(due_of_unstable(0.5), second_window) << "a motion that decays";
  EXPECT_EQ(due_of_unstable(1.2), second_window) << "1.1 in half a window is no growth yet";
  EXPECT_EQ(due_of_unstable(1.4), 70) << "1.18 in half a window is";
  EXPECT_EQ(due_of_unstable(2), 70) << "the last five looks after the fall have lower energies";
  for (const int resumed : {3, 20, 25, 67}) EXPECT_EQ(due_of_unstable(2, resumed), 70);
}

TEST(Quench, BeginsToJudgeAnewAfterEachQuenchAndPressure) {
  RestingStory story([](std::int64_t) { return Unrest{.force_imbalance = 5e-3, .kinetic_energy = 1e-12}; });
  Quench quench(story.watch);
  std::vector<int> due;
  for (int look = 1; look <= 60; ++look) {
    story.simulation.advance(story.watch.period(), nullptr);
    if (look == 35) story.simulation.model().barostat.pressure *= 1.001;
    if (!quench.due(story.now)) continue;
    due.push_back(look);
    quench.fire(story.now);
  }
  EXPECT_EQ(due, (std::vector{20, 30, 50, 60})) << "at 40 the window holds looks under another pressure";
}

/// How many windows it waits while the forces of a slow packing do not balance; at the end of window
/// `restless` there is a moment of motion, and after window `resumed` another process goes on.
int windows_until_due(int restless = -1, int resumed = -1) {
  const auto length = RestWatch({}, story_rhythm).window_length();
  RestingStory story([&](std::int64_t step) {
    return Unrest{.force_imbalance = 0.5, .kinetic_energy = step == restless * length ? 1.0 : 0.0};
  });
  return first_due(story, 1000, 10 * resumed) / 10;
}

TEST(Quench, DoesNotWaitForEverForTheForcesToBalance) {
  EXPECT_EQ(windows_until_due(), 51);
  EXPECT_EQ(windows_until_due(5), 53);
  for (int resumed : {1, 4, 11, 52}) EXPECT_EQ(windows_until_due(5, resumed), 53);
}

TEST(Quench, RefusesAMemoryThatIsNone) {
  RestWatch watch({}, story_rhythm);
  Quench quench(watch);
  quench.restore("");
  quench.restore("2 0.5 1");
  EXPECT_EQ(quench.saved(), "2 0.5 1");
  quench.restore("2 0.5 1 3 1.5e-5");
  EXPECT_EQ(quench.saved(), "2 0.5 1 3 1.5e-05");
  for (const char* saved : {"2", "2 0.5", "2 0.5 1 x", "2 0.5 1 3 -1", "2 0.5 1 3 nan", "-1 0.5 1",
                            "2 -0.5 1", "2 0.5 -1", "2 0.5 1 1 2 3 4 5 6 7 8 9 10 11", " "})
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
  for (double window : {0.06, 0.2, 0.3, 20.1, 200.0}) {
    RestCriteria criteria;
    criteria.window = window;
    RestWatch watch(criteria, story_rhythm);
    const Quench quench(watch);
    for (std::int64_t step = quench.next(0), n = 0; n < 5; step = quench.next(step), ++n)
      EXPECT_EQ(step % watch.period(), 0) << "window " << window;
    EXPECT_EQ(quench.next(0), watch.period());
  }
}

}  // namespace
}  // namespace furnas
