#include "engine/events/settle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "engine/base/require.h"
#include "engine/events/limits.h"
#include "tests/engine/events/resting_story.h"
#include "tests/engine/support/dice.h"
#include "tests/engine/support/property.h"

namespace furnas {
namespace {

using test::Dice;

TEST(PhiRecord, KnowsTheRangeOfAllThatItHasSeenSinceAStep) {
  PhiRecord record;
  for (std::int64_t step = 1; step <= 60; ++step)
    record.add(step, 0.6 + 0.001 * static_cast<double>(step), step == 50 ? 0.3 : 0.1);
  const PhiRecord::Span late = record.since(40);
  EXPECT_EQ(late.low, 0.6 + 0.001 * 41);
  EXPECT_EQ(late.high, 0.6 + 0.001 * 60);
  EXPECT_EQ(late.stress_error, 0.3);
  EXPECT_EQ(record.spans().size(), 60u);
  EXPECT_EQ(record.since(50).stress_error, 0.1);
  EXPECT_EQ(record.since(1000).low, 0.6 + 0.001 * 60) << "the last look always counts";
}

// It never forgets an extreme, and the spans that it holds are short beside the past that is asked for.
TEST(PhiRecord, HoldsAnyPastInFewSpans) {
  EXPECT_TRUE(test::holds(50, [] {
    Dice dice(test::any_seed());
    const auto looks = 1 + static_cast<std::int64_t>(dice.below(3000));
    std::vector<double> phi;
    PhiRecord record;
    for (std::int64_t k = 0; k < looks; ++k) {
      phi.push_back(dice.between(0.5, 0.7));
      record.add(k, phi.back(), 0);
    }
    RC_ASSERT(record.spans().size() <= 64);
    const auto from = static_cast<std::int64_t>(dice.below(static_cast<std::uint64_t>(looks)));
    const auto [low, high] = std::minmax_element(phi.begin() + from, phi.end());
    const PhiRecord::Span seen = record.since(from - 1);
    RC_ASSERT(seen.low <= *low);
    RC_ASSERT(seen.high >= *high);
    const auto before = std::max<std::int64_t>(from - looks / 32 - 1, 0);
    const auto [lowest, highest] = std::minmax_element(phi.begin() + before, phi.end());
    RC_ASSERT(seen.low >= *lowest);
    RC_ASSERT(seen.high <= *highest);
  }));
}

/// A made-up run whose verdict may be settled. phi goes as 1/volume: a strain of the cell lowers it.
struct Told {
  RestingStory story;
  Quench quench{story.watch};
  std::vector<RestingState> reached;
  NextPressure last{story.watch, {}, reached};

  explicit Told(const RestingStory::Tale& tale, double phi_error)
      : story(tale, {.stilling = 0, .phi_error = phi_error}) {}

  /// The step at which the run ends as settled; -1 if it does not. At look `resumed` another process goes on.
  std::int64_t settles_at(int looks, int resumed = 0) {
    auto event = std::make_unique<Settle>(story.watch, last, quench, story_rhythm.steps(drift_time));
    for (int look = 1; look <= looks; ++look) {
      story.simulation.advance(story.watch.period(), nullptr);
      quench.due(story.now);
      const bool due = event->due(story.now);
      bound = event->bound();
      if (due) return story.simulation.step();
      if (look != resumed) continue;
      const std::string saved = event->saved();
      event = std::make_unique<Settle>(story.watch, last, quench, story_rhythm.steps(drift_time));
      event->restore(saved);
    }
    return -1;
  }

  double bound = 0;
};

/// A packing that creeps as the logarithm of its age, `creep` in phi for a factor of e.
RestingStory::Tale creeping(double creep, double stress_error = 0) {
  return [=](std::int64_t step) {
    const double phi = almost_resting({}).fraction_filled();
    return Unrest{.stress_error = stress_error,
                  .force_imbalance = 5e-3,
                  .strain = phi / (phi + creep * std::log(static_cast<double>(step))) - 1};
  };
}

// Closed form: such creep moves phi by `creep` ln 2 in each doubling of its age.
TEST(Settle, BoundsCreepByFiveDoublingsOfTheAge) {
  constexpr double creep = 1e-5;
  Told told(creeping(creep), 0);
  EXPECT_EQ(told.settles_at(1000), -1) << "not asked for";
  const double exact = 5 * creep * std::log(2);
  EXPECT_GT(told.bound, exact);
  EXPECT_LT(told.bound, 1.1 * exact) << "spans make it a little longer";
}

TEST(Settle, AllowsFourTimesAsMuchWithoutFrictionAwayFromRest) {
  constexpr double creep = 1e-5;
  const RestCriteria c;
  const auto bound_at = [](double force_imbalance, double kinetic_energy) {
    const auto tale = [=](std::int64_t step) {
      Unrest unrest = creeping(creep)(step);
      unrest.force_imbalance = force_imbalance;
      unrest.kinetic_energy = kinetic_energy;
      return unrest;
    };
    Told told(tale, 0);
    told.story.simulation.model().law = Frictionless<true>{};
    told.settles_at(1000);
    return told.bound;
  };
  const double near_rest = bound_at(5e-3, 0);
  EXPECT_NEAR(near_rest, 5 * creep * std::log(2), 0.5 * creep);
  EXPECT_NEAR(bound_at(2e-2, 0), 4 * near_rest, 1e-9 * near_rest);
  EXPECT_NEAR(bound_at(5, 0), 4 * near_rest, 1e-9 * near_rest);
  EXPECT_NEAR(bound_at(5e-3, 101 * c.kinetic_energy), 4 * near_rest, 1e-9 * near_rest);
}

TEST(Settle, EndsTheRunOnceTheBoundIsSmallEnough) {
  EXPECT_EQ(Told(creeping(1e-5), 3e-5).settles_at(1000), -1);
  const std::int64_t least = story_rhythm.steps(drift_time);
  const std::int64_t window = RestWatch({}, story_rhythm).window_length();
  const std::int64_t at = Told(creeping(1e-5), 4e-5).settles_at(1000);
  EXPECT_GE(at, least);
  EXPECT_LE(at, least + 2 * window);
  EXPECT_EQ(at % window, 0);
  for (const int resumed : {1, 50, 99, 105})
    EXPECT_EQ(Told(creeping(1e-5), 4e-5).settles_at(1000, resumed), at);
}

// An avalanche counts until it lies in the earlier half of the age.
TEST(Settle, WaitsAfterAnAvalancheAsLongAsThePackingWasOld) {
  const std::int64_t window = RestWatch({}, story_rhythm).window_length();
  const auto early = [&](std::int64_t step) {
    return Unrest{.force_imbalance = 5e-3, .strain = step > 8 * window ? -1e-2 : 0};
  };
  const std::int64_t after = Told(early, 1e-4).settles_at(2000);
  EXPECT_GE(after, 16 * window);
  EXPECT_LE(after, 20 * window);
}

// The stress that is wrong by 0.5 % moves phi by 3 phi times the unloading strain times that, and 3 times as
// much where contacts do not follow the cell.
TEST(Settle, CountsTheStressThatIsWrong) {
  Told told(creeping(0, 5e-3), 0);
  told.settles_at(200);
  const Packing p = almost_resting({.stress_error = 5e-3});
  const double strain = 0.1 / 0.9;  // overlap over distance, of all contacts
  EXPECT_NEAR(told.bound, 9 * p.fraction_filled() * strain * 5e-3, 1e-9);
}

TEST(Settle, KnowsNoBoundAwayFromRest) {
  const RestCriteria c;
  const auto bound_of = [](const Unrest& unrest) {
    Told told([unrest](std::int64_t) { return unrest; }, 0);
    told.settles_at(200);
    return told.bound;
  };
  EXPECT_LT(bound_of({.force_imbalance = 5e-3}), 1e-9);
  EXPECT_EQ(bound_of({.force_imbalance = 1.01e-2}), RestReport::unknown);
  EXPECT_EQ(bound_of({.kinetic_energy = 101 * c.kinetic_energy}), RestReport::unknown);
  EXPECT_EQ(bound_of({.stress_error = 1.01e-2}), RestReport::unknown);
  EXPECT_EQ(bound_of({.contacts = false}), RestReport::unknown);
}

TEST(Settle, KnowsNoBoundWhileMotionGrows) {
  const auto growing = [](std::int64_t step) {
    return Unrest{.kinetic_energy = 1e-20 * std::exp(1e-4 * static_cast<double>(step))};
  };
  Told told(growing, 0);
  told.settles_at(150);
  EXPECT_EQ(told.bound, RestReport::unknown);
}

TEST(Settle, BeginsAnewWhereThePressureIsLost) {
  const std::int64_t window = RestWatch({}, story_rhythm).window_length();
  const auto bounce = [&](std::int64_t step) {
    return Unrest{.stress_error = step == 15 * window ? -0.9 : 0.0, .force_imbalance = 5e-3};
  };
  EXPECT_EQ(Told(bounce, 1e-4).settles_at(90), -1);
  Told again([&](std::int64_t step) { return bounce(step + 10 * window); }, 1e-4);
  EXPECT_EQ(again.settles_at(1000), 16 * window) << "the first end of a window ten of them after it";
}

/// What the packing did at the first pressure is no part of its age at the second, and its bound there is a
/// part of its bound at the second.
TEST(Settle, GoesOnToTheNextPressure) {
  constexpr double creep = 1e-5, phi_error = 1e-4;
  const std::int64_t least = story_rhythm.steps(drift_time);
  const std::int64_t window = RestWatch({}, story_rhythm).window_length();
  RestingStory story(creeping(creep), {.stilling = 0, .phi_error = phi_error});
  std::vector<RestingState> reached;
  Events events;
  auto next =
      std::make_unique<NextPressure>(story.watch, std::vector<Barostat>{{.pressure = 1.001e-4}}, reached);
  auto quench = std::make_unique<Quench>(story.watch);
  auto settle = std::make_unique<Settle>(story.watch, *next, *quench, least);
  const Settle& last = *settle;
  events.push_back(std::move(next));
  events.push_back(std::move(quench));
  events.push_back(std::move(settle));
  events.push_back(std::make_unique<Budget>(10 * least));
  EXPECT_EQ(compact(story.now, events), Verdict::settled);
  EXPECT_EQ(story.simulation.model().barostat.pressure, 1.001e-4);
  ASSERT_EQ(reached.size(), 1u) << "the last pressure is the verdict's";
  EXPECT_EQ(reached[0].pressure, 1e-4);
  EXPECT_NEAR(reached[0].phi_bound, 5 * creep * std::log(2), 0.5 * creep);
  EXPECT_LT(reached[0].phi_bound, 2.0 / 3 * phi_error);
  EXPECT_LE(reached[0].step, least + 2 * window);
  EXPECT_GE(story.now.step(), reached[0].step + least);
  EXPECT_GT(last.bound(), reached[0].phi_bound);
  EXPECT_LT(last.bound(), phi_error);
}

TEST(Settle, RefusesAMemoryThatIsNone) {
  RestWatch watch({}, story_rhythm);
  const Quench quench(watch);
  std::vector<RestingState> reached;
  NextPressure last(watch, {}, reached);
  Settle settle(watch, last, quench, 1);
  settle.restore("");
  for (const char* text :
       {"x", "1", "-1 0", "1 -1", "1 0 1 5 0.6 0.7", "1 0 1 5 0.7 0.6 0", "1 0 0 5 0.6 0.7 0", "1 0 x"})
    EXPECT_THROW(settle.restore(text), InputError) << text;
  std::string long_past = "1 inf";
  for (int span = 0; span < 65; ++span) long_past += " 1 5 0.6 0.7 0";
  EXPECT_THROW(settle.restore(long_past), InputError);
  settle.restore("1 inf 1 5 0.6 0.7 0");
  EXPECT_EQ(settle.bound(), RestReport::unknown);
}

}  // namespace
}  // namespace furnas
