#include "engine/events/at_rest.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/events/limits.h"
#include "tests/engine/events/resting_story.h"

namespace furnas {
namespace {

RestingStory always(const Unrest& unrest, const RestCriteria& criteria = {}) {
  return RestingStory([unrest](std::int64_t) { return unrest; }, criteria);
}

/// What one criterion says just below and just above its limit.
struct Boundary {
  const char* waits_for;
  Unrest below, above;
};

Unrest with(double Unrest::*part, double value) {
  Unrest unrest;
  unrest.*part = value;
  return unrest;
}

Boundary boundary(const char* name, double Unrest::*part, double limit) {
  return {name, with(part, 0.999 * limit), with(part, 1.001 * limit)};
}

TEST(RestWatch, TheStoryIsAsItsUnrestSays) {
  RestingStory story =
      always({.stress_error = 0.1, .force_imbalance = 0.2, .kinetic_energy = 0.3, .rattler_energy = 6});
  const Measures& m = story.now.measures();
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(m.stress[k], 1.1e-4, 1e-17);
  EXPECT_NEAR(m.force_imbalance, 0.2, 1e-14);
  EXPECT_NEAR(m.backbone_kinetic_energy, 0.3, 1e-14);
  EXPECT_NEAR(m.kinetic_energy, (5 * 0.3 + 6) / 6, 1e-14);
  EXPECT_NEAR(always({.shear = 0.1}).now.measures().stress[3], 1e-5, 1e-17);
}

TEST(RestWatch, TheWindowMustBeFull) {
  RestingStory story = always({});
  EXPECT_EQ(story.watch.period(), 1000);
  EXPECT_EQ(story.rests_at(), 11'000);  // the first look is at step 1000
  EXPECT_TRUE(story.watch.report().waiting_for.empty());
  EXPECT_FALSE(story.watch.report().loosely);
  RestingStory young = always({});
  young.rests_at(10);
  EXPECT_EQ(young.watch.report().waiting_for, "the window");
  EXPECT_TRUE(std::isinf(young.watch.report().strain_drift));
}

// A contact law that is pressed beyond its range is no rest, and the run says so.
TEST(RestWatch, LargeOverlapsAreNamed) {
  RestCriteria criteria;
  criteria.largest_overlap = 1e-12;
  RestingStory story = always({}, criteria);
  EXPECT_EQ(story.rests_at(20), -1);
  EXPECT_EQ(story.watch.report().waiting_for, "smaller overlaps");
}

TEST(RestWatch, AWindowIsAsLongAsTheCriteriaSay) {
  RestCriteria criteria;
  criteria.window = 1;  // 50 steps
  EXPECT_EQ(always({}, criteria).rests_at(), 55);
  criteria.window = 0.06;  // fewer steps than looks
  EXPECT_EQ(always({}, criteria).rests_at(), 11);
}

TEST(RestWatch, OneBadLookBeginsTheWindowAnew) {
  RestingStory story([](std::int64_t step) { return Unrest{.stress_error = step == 7000 ? 0.1 : 0}; });
  EXPECT_EQ(story.rests_at(), 18'000);
}

TEST(RestWatch, EachCriterionHasItsLimit) {
  const RestCriteria c;
  const Boundary table[] = {
      boundary("stress", &Unrest::stress_error, c.stress_error),
      boundary("stress", &Unrest::stress_error, -c.stress_error),
      boundary("stress", &Unrest::shear, c.stress_error),
      boundary("stress", &Unrest::shear, -c.stress_error),
      boundary("force balance", &Unrest::force_imbalance, c.force_imbalance),
      boundary("kinetic energy", &Unrest::kinetic_energy, c.kinetic_energy),
  };
  for (const Boundary& b : table) {
    EXPECT_EQ(always(b.below).rests_at(), 11'000) << b.waits_for;
    RestingStory above = always(b.above);
    EXPECT_EQ(above.rests_at(12), -1) << b.waits_for;
    EXPECT_EQ(above.watch.report().waiting_for, b.waits_for);
  }
}

TEST(RestWatch, RattlersMayMove) { EXPECT_EQ(always({.rattler_energy = 1}).rests_at(), 11'000); }

TEST(RestWatch, NothingRestsWithoutContacts) {
  EXPECT_EQ(always({.contacts = false}).rests_at(), -1);
  RestCriteria paper;
  paper.kinetic_energy_alone = true;
  EXPECT_EQ(always({.contacts = false}, paper).rests_at(), -1);
}

TEST(RestWatch, TheCellMayNotDrift) {
  const RestCriteria c;
  const auto drifting = [&](double share) {
    const double rate = share * c.strain_drift / 1e5;
    return RestingStory(
        [rate](std::int64_t step) { return Unrest{.strain = rate * static_cast<double>(step)}; });
  };
  RestingStory slow = drifting(0.99);
  EXPECT_EQ(slow.rests_at(), 11'000);
  EXPECT_NEAR(slow.watch.report().strain_drift, 0.99 * c.strain_drift, 1e-4 * c.strain_drift);
  RestingStory fast = drifting(1.01);
  EXPECT_EQ(fast.rests_at(), -1);
  EXPECT_EQ(fast.watch.report().waiting_for, "strain drift");
  EXPECT_EQ(drifting(-1.01).rests_at(), -1);
}

/// Each of the six deformations counts.
TEST(RestWatch, EveryStrainIsADrift) {
  for (double Triangle::*edge :
       {&Triangle::xx, &Triangle::yy, &Triangle::zz, &Triangle::yz, &Triangle::xz, &Triangle::xy}) {
    FakeSimulation simulation([edge](std::int64_t step) {
      Packing p = almost_resting({});
      p.cell.edges.*edge += 1e-5 * static_cast<double>(step);
      return p;
    });
    Observation now(simulation, 3);
    RestWatch watch({}, story_rhythm);
    for (int n = 0; n < 11; ++n) simulation.advance(1000, nullptr), watch.look(now);
    EXPECT_NEAR(watch.report().strain_drift, 0.1, 0.002);  // 1e-6 a step of an edge of 10
  }
}

TEST(RestWatch, TheLooseLimitNeedsTenWindows) {
  RestingStory story = always({.force_imbalance = 5e-4});
  EXPECT_EQ(story.rests_at(), 101'000);
  EXPECT_TRUE(story.watch.report().loosely);
  EXPECT_EQ(always({.force_imbalance = 1.001e-3}).rests_at(), -1);
}

TEST(RestWatch, TightIsNotCalledLoose) {
  RestingStory story(
      [](std::int64_t step) { return Unrest{.force_imbalance = step < 95'000 ? 5e-4 : 5e-5}; });
  EXPECT_EQ(story.rests_at(), 101'000);  // ten windows, though the last looks are tight
  EXPECT_TRUE(story.watch.report().loosely);
  RestingStory sooner(
      [](std::int64_t step) { return Unrest{.force_imbalance = step < 30'000 ? 5e-4 : 5e-5}; });
  EXPECT_EQ(sooner.rests_at(), 40'000);
  EXPECT_FALSE(sooner.watch.report().loosely);
}

/// The study's own rule asks for the kinetic energy of all particles and for nothing else.
TEST(RestWatch, ThePapersRuleIsTheKineticEnergyAlone) {
  RestCriteria paper;
  paper.kinetic_energy_alone = true;
  const Unrest anything{.stress_error = 3, .shear = 1, .force_imbalance = 0.5};
  EXPECT_EQ(always(anything, paper).rests_at(), 11'000);
  EXPECT_EQ(always({.kinetic_energy = 0.999e-11, .rattler_energy = 0.999e-11}, paper).rests_at(), 11'000);
  RestingStory whirling = always({.rattler_energy = 6.01e-11}, paper);  // a sixth of it for each
  EXPECT_EQ(whirling.rests_at(), -1);
  EXPECT_EQ(whirling.watch.report().waiting_for, "kinetic energy");
}

TEST(RestWatch, LooksOnceAStep) {
  RestingStory story = always({});
  for (int n = 0; n < 30; ++n) story.watch.look(story.now);
  EXPECT_FALSE(story.watch.report().resting);
  EXPECT_EQ(story.watch.saved().window.size(), 1u);
}

TEST(RestWatch, GoesOnFromAWindowThatWasKept) {
  RestingStory story = always({});
  EXPECT_EQ(story.rests_at(7), -1);
  RestWatch another({}, story_rhythm);
  another.restore(story.watch.saved());
  EXPECT_EQ(another.report().waiting_for, story.watch.report().waiting_for);
  EXPECT_EQ(another.report().strain_drift, story.watch.report().strain_drift);
  EXPECT_EQ(another.report().stress_error, story.watch.report().stress_error);
  for (int n = 0; n < 3; ++n) {
    story.simulation.advance(1000, nullptr);
    EXPECT_FALSE(another.look(story.now).resting);
  }
  story.simulation.advance(1000, nullptr);
  EXPECT_TRUE(another.look(story.now).resting);
}

TEST(StressError, CountsWhatTheCellCanAnswerTo) {
  Measures m;
  m.stress = {1.1e-4, 1e-4, 0.7e-4, 0.5e-4, 0, 0};
  m.pressure = 2.8e-4 / 3;
  const auto error = [&](CellFreedom freedom) {
    return stress_error(m, {.freedom = freedom, .pressure = 1e-4});
  };
  EXPECT_NEAR(error(CellFreedom::triclinic), 0.5, 1e-12);
  EXPECT_NEAR(error(CellFreedom::orthorhombic), 0.3, 1e-12);
  EXPECT_NEAR(error(CellFreedom::cubic), 0.2 / 3, 1e-12);
}

TEST(AtRest, EndsTheRunAsJammed) {
  RestingStory story = always({});
  Events events;
  events.push_back(std::make_unique<AtRest>(story.watch, 50));
  EXPECT_EQ(compact(story.now, events), Verdict::jammed);
  EXPECT_EQ(story.now.step(), 11'000);
}

/// The steps at which a made-up run takes out all motion at its end, and the step at which it is jammed.
/// After each of these events another process continues.
std::vector<std::int64_t> end_of(RestingStory& story) {
  std::vector<std::int64_t> steps;
  auto at_rest = std::make_unique<AtRest>(story.watch, 50);
  for (std::int64_t next = at_rest->next(0); next < 100'000; next = at_rest->next(next)) {
    story.simulation.advance(next - story.now.step(), nullptr);
    if (!at_rest->due(story.now)) continue;
    steps.push_back(next);
    if (at_rest->fire(story.now)) {
      EXPECT_EQ(at_rest->count(), story.now.replaced());
      return steps;
    }
    const std::string saved = at_rest->saved();
    at_rest = std::make_unique<AtRest>(story.watch, 50);
    at_rest->restore(saved);
  }
  return {};
}

TEST(AtRest, QuenchesAtTheEndAsOftenAsTheCriteriaSay) {
  using Steps = std::vector<std::int64_t>;
  RestingStory none = always({.rattler_energy = 1}),
               three = always({.rattler_energy = 1}, {.final_quenches = 3});
  EXPECT_EQ(end_of(none), (Steps{11'000}));
  EXPECT_NEAR(none.now.measures().kinetic_energy, 1.0 / 6, 1e-15);
  EXPECT_EQ(end_of(three), (Steps{11'000, 11'050, 11'100, 12'000}));
  EXPECT_EQ(three.now.measures().kinetic_energy, 0);
}

// At step 12 000 the packing is no longer at rest, so a full window must pass again.
TEST(AtRest, QuenchesAgainIfThePackingDoesNotStayAtRest) {
  RestingStory story = always({}, {.final_quenches = 2});
  AtRest at_rest(story.watch, 50);
  std::vector<std::int64_t> steps;
  for (std::int64_t next = 1000;; next = at_rest.next(next)) {
    story.simulation.advance(next - story.now.step(), nullptr);
    if (next == 12'000) story.now.replace(almost_resting({.force_imbalance = 0.1}));
    if (next == 13'000) story.now.replace(almost_resting({}));
    if (!at_rest.due(story.now)) continue;
    steps.push_back(next);
    if (at_rest.fire(story.now)) break;
  }
  EXPECT_EQ(steps, (std::vector<std::int64_t>{11'000, 11'050, 23'000, 23'050, 24'000}));
}

TEST(AtRest, RefusesAMemoryThatIsNone) {
  RestWatch watch({.final_quenches = 5}, story_rhythm);
  AtRest at_rest(watch, 50);
  EXPECT_EQ(at_rest.saved(), "");
  at_rest.restore("");
  at_rest.restore("2 11000 7");
  EXPECT_EQ(at_rest.saved(), "2 11000 7");
  EXPECT_EQ(at_rest.next(11'050), 11'100);
  for (const char* saved :
       {"2", "2 11000", "2 11000 1", "-1 11000 7", "6 11000 7", "2 -1 7", "2 11000 7 ", " "})
    EXPECT_THROW(at_rest.restore(saved), InputError) << saved;
}

std::vector<Barostat> baths_at(const std::vector<double>& pressures) {
  std::vector<Barostat> baths;
  for (const double pressure : pressures) baths.push_back({.pressure = pressure});
  return baths;
}

/// Two pressures are left; each needs a full window, the last one ends the run.
TEST(NextPressure, GoesDownTheListAndThenTheRunEnds) {
  RestingStory story = always({});
  std::vector<RestingState> reached;
  Events events;
  events.push_back(std::make_unique<NextPressure>(story.watch, baths_at({1.0005e-4, 1.0009e-4}), reached));
  events.push_back(std::make_unique<AtRest>(story.watch, 50));
  EXPECT_EQ(compact(story.now, events), Verdict::jammed);
  // The first look at a new pressure is taken at the step at which it is set.
  EXPECT_EQ(story.now.step(), 31'000);
  EXPECT_EQ(story.simulation.model().barostat.pressure, 1.0009e-4);
  ASSERT_EQ(reached.size(), 2u);
  EXPECT_EQ(reached[0].pressure, 1e-4);
  EXPECT_EQ(reached[0].step, 11'000);
  EXPECT_EQ(reached[1].pressure, 1.0005e-4);
  EXPECT_EQ(reached[1].step, 21'000);
  const Measures& m = story.now.measures();
  for (const RestingState& s : reached) {
    EXPECT_EQ(s.phi, m.phi);
    EXPECT_EQ(s.Z_backbone, m.backbone().coordination);
    EXPECT_EQ(s.large_rattlers, m.backbone().large);
    EXPECT_EQ(s.small_rattlers, m.backbone().small);
  }
}

/// The stress that was right for one pressure is wrong for the next: it does not rest at once.
TEST(NextPressure, WaitsForTheNewStress) {
  RestingStory story = always({});
  std::vector<RestingState> reached;
  Events events;
  events.push_back(std::make_unique<NextPressure>(story.watch, baths_at({2e-4}), reached));
  events.push_back(std::make_unique<AtRest>(story.watch, 50));
  events.push_back(std::make_unique<Budget>(200'000));
  EXPECT_EQ(compact(story.now, events), Verdict::budget);
  EXPECT_EQ(reached.size(), 1u);
  EXPECT_NEAR(story.watch.report().stress_error, 0.5, 1e-12);
}

TEST(RestReport, KnowsNothingBeforeTheFirstLook) {
  const RestReport report = RestWatch({}, story_rhythm).report();
  EXPECT_FALSE(report.resting);
  for (double x : {report.stress_error, report.force_imbalance, report.kinetic_energy, report.strain_drift})
    EXPECT_TRUE(std::isinf(x));
}

}  // namespace
}  // namespace furnas
