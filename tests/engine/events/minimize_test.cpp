#include "engine/events/minimize.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

#include "engine/certificate/certify.h"
#include "engine/protocol/run.h"
#include "engine/start/mixture.h"
#include "engine/state/fingerprint.h"
#include "tests/engine/events/resting_story.h"

namespace furnas {
namespace {

/// Whether it is due after a look at a packing like this; all of its contacts overlap by `overlap`.
bool due(const Unrest& unrest, double overlap = 1e-3) {
  RestingStory story([&](std::int64_t) { return unrest; });
  story.simulation.advance(story.watch.period(), nullptr);
  Packing p = story.now.packing();
  for (Contact& c : p.contacts) c.overlap = overlap;
  story.now.replace(p);
  return Minimize(story.watch).due(story.now);
}

TEST(Minimize, IsDueWhenAPackingStandsButDoesNotRest) {
  EXPECT_TRUE(due({.force_imbalance = 0.05}));
  EXPECT_TRUE(due({.stress_error = 0.04}));
  EXPECT_FALSE(due({.stress_error = 0.06}));
  EXPECT_FALSE(due({.force_imbalance = 0.05, .contacts = false}));
  EXPECT_FALSE(due({})) << "what rests needs no minimizer";
}

// 30 contacts with an energy of overlap^2/2 each, and one rattler that moves.
TEST(Minimize, WaitsUntilTheMotionIsSmallAgainstTheSprings) {
  constexpr double overlap = 1e-3;
  constexpr double springs = 30 * 0.5 * overlap * overlap;
  EXPECT_TRUE(due({.force_imbalance = 0.05, .rattler_energy = 0.04 * springs}, overlap));
  EXPECT_FALSE(due({.force_imbalance = 0.05, .rattler_energy = 0.06 * springs}, overlap));
}

// A large packing is left to the steps until its rearrangements are over.
TEST(Minimize, WaitsForTheBalanceOfALargePacking) {
  EXPECT_TRUE(due({.force_imbalance = 0.0031, .groups = 299})) << "1495 spheres";
  EXPECT_FALSE(due({.force_imbalance = 0.0031, .groups = 300})) << "1500 spheres";
  EXPECT_TRUE(due({.force_imbalance = 0.0029, .groups = 300}));
}

// Five spheres carry the load, and many small ones between them touch: 30 contacts and those of the pairs.
TEST(Minimize, WaitsForTheBalanceWhereManySpheresTouch) {
  EXPECT_TRUE(due({.force_imbalance = 0.0031, .pairs = 19'969})) << "19 999 contacts";
  EXPECT_FALSE(due({.force_imbalance = 0.0031, .pairs = 19'970})) << "20 000 contacts";
  EXPECT_TRUE(due({.force_imbalance = 0.0029, .pairs = 19'970}));
}

TEST(Minimize, LeavesThePackingToTheStepsAfterASearch) {
  RestingStory story([](std::int64_t) { return Unrest{.force_imbalance = 0.05}; });
  Minimize minimize(story.watch);
  minimize.restore("20000 0 0.0001 0 5000");
  std::int64_t step = 0;
  do {
    step = minimize.next(step);
    story.simulation.advance(step - story.now.step(), nullptr);
  } while (!minimize.due(story.now) && step < 100'000);
  EXPECT_EQ(step, 5000);
  minimize.restore("20000 0 0.001 0 500000");
  EXPECT_TRUE(minimize.due(story.now)) << "another pressure is a new beginning";
}

TEST(Minimize, RefusesAMemoryThatIsNone) {
  RestWatch watch({}, story_rhythm);
  Minimize minimize(watch);
  minimize.restore("");
  minimize.restore("20 1 0.5 10 300");
  EXPECT_EQ(minimize.saved(), "20 1 0.5 10 300");
  EXPECT_EQ(minimize.next(300), 301) << "in the middle of a search";
  minimize.restore("20 0 0.5 10 300");
  EXPECT_EQ(minimize.next(300), 1000);
  for (const char* saved : {"2", "20 1 0.5 10", "20 1 0.5 10 300 ", "20 3 0.5 10 300", "-1 1 0.5 10 300",
                            "20 1 -0.5 10 300", "20 1 nan 10 300", "20 1 0.5 -1 300", "20 1 0.5 10 -2", " "})
    EXPECT_THROW(minimize.restore(saved), InputError) << saved;
}

/// Spheres without friction in steps of a tenth of a collision time.
Protocol frictionless() {
  Protocol protocol;
  protocol.contact.friction = 0;
  protocol.steps = 200'000;
  return protocol;
}

Packing spheres(std::int64_t count) {
  return dilute_start({.large = count, .start_fraction = 0.2, .seed = 3});
}

/// What a run comes to.
struct Ending {
  Verdict verdict;
  std::uint64_t hash;
  std::int64_t step, evaluations;
  double gap;
  Measures measures;
  Packing packing;
};

Ending ending_of(ProtocolRun& run, const Outcome& outcome) {
  const Measures m = run.now().measures();
  return {outcome.verdict,    state_hash(run.now().packing()),         m.step,
          run.evaluations(),  m.ledger.relative_gap(m.energy.total()), m,
          run.now().packing()};
}

Ending jam_of(const Protocol& protocol, const Packing& start, int threads) {
  // As many threads as asked for, whatever the machine has.
  const tbb::global_control more(tbb::global_control::max_allowed_parallelism, 4);
  ProtocolRun run(protocol, start, threads);
  run.begin();
  const Outcome outcome = run.go();
  return ending_of(run, outcome);
}

// 300 spheres come to rest: forces balance far better than the verdict asks, the energy balances, the packing
// passes every part of the certificate, and three threads leave the same bits.
TEST(Minimize, BringsSpheresWithoutFrictionToRest) {
  const Protocol protocol = frictionless();
  const Ending end = jam_of(protocol, spheres(300), 1);
  ASSERT_EQ(end.verdict, Verdict::jammed);
  EXPECT_GT(end.evaluations, 100);
  EXPECT_LT(end.step + end.evaluations, 80'000);
  EXPECT_NEAR(end.measures.phi, 0.63, 0.02);
  EXPECT_LT(end.measures.force_imbalance, 1e-5);
  EXPECT_LT(std::abs(end.gap), 0.06);
  EXPECT_TRUE(certify(end.packing, {}).passed());

  const Ending other = jam_of(protocol, spheres(300), 3);
  EXPECT_EQ(other.hash, end.hash);
  EXPECT_EQ(other.evaluations, end.evaluations);
}

TEST(Minimize, LooksAtOnceWhenThePressureHasChanged) {
  RestWatch watch({}, story_rhythm);
  std::vector<RestingState> reached{{.pressure = 1e-3, .step = 2000}};
  const NextPressure pressures(watch, {}, reached);
  const Minimize minimize(watch, 0, &pressures);
  EXPECT_EQ(minimize.next(2000), 2001);
  EXPECT_EQ(minimize.next(2001), 3000);
}

/// The smallest phi under one pressure.
class LowestPhi final : public Event {
 public:
  LowestPhi(double pressure, double& lowest) : pressure_(pressure), lowest_(lowest) {}
  const char* name() const override { return "lowest phi"; }
  std::int64_t next(std::int64_t step) const override { return next_multiple(step, 10); }
  bool due(Observation& now) override {
    if (now.simulation().model().barostat.pressure == pressure_)
      lowest_ = std::min(lowest_, now.measures().phi);
    return false;
  }
  std::optional<Verdict> fire(Observation&) override { return {}; }

 private:
  double pressure_;
  double& lowest_;
};

// In time steps the energy of the contacts drives the cell apart when the pressure falls.
TEST(Minimize, UnloadsWithoutDilatingThePacking) {
  const auto dilation = [](bool minimizer) {
    Protocol protocol = frictionless();
    protocol.pressures = {1e-2, 1e-3};
    protocol.minimizer = minimizer;
    ProtocolRun run(protocol, spheres(300), 1);
    double lowest = 1;
    Onlookers onlookers;
    onlookers.before_verdict.push_back(std::make_unique<LowestPhi>(1e-3, lowest));
    run.begin(std::move(onlookers));
    EXPECT_EQ(run.go().verdict, Verdict::jammed);
    return run.now().measures().phi - lowest;
  };
  EXPECT_LT(dilation(true), 1e-4);
  EXPECT_GT(dilation(false), 1e-3);
}

// A search that has spent 20 000 evaluations ends in a large packing and goes on in a small one.
TEST(Minimize, EndsItsSearchOfALargePackingSooner) {
  Protocol protocol = frictionless();
  protocol.minimizer = false;
  protocol.steps = 5000;
  ProtocolRun run(protocol, spheres(50), 1);
  run.begin();
  run.go();
  const auto goes_on = [&](std::int64_t backbone) {
    RestWatch watch({}, story_rhythm);
    watch.restore({.window = {}, .backbone = backbone});
    Minimize minimize(watch, 1);
    minimize.restore("20000 1 0.0001 20000 0");
    minimize.fire(run.now());
    return minimize.next(6000) == 6001;
  };
  EXPECT_TRUE(goes_on(1499));
  EXPECT_FALSE(goes_on(1500));
}

// The energy that goes is booked to the last digit: what the balance misses does not change.
TEST(Minimize, KeepsTheBalanceOfTheEnergy) {
  Protocol protocol = frictionless();
  protocol.minimizer = false;
  protocol.steps = 30'000;
  ProtocolRun run(protocol, spheres(300), 1);
  run.begin();
  run.go();
  Observation& now = run.now();
  const Measures before = now.measures();
  Minimize minimize(run.watch());
  minimize.fire(now);
  const Measures after = now.measures();
  const auto gap = [](const Measures& m) { return m.ledger.gap(m.energy.total()); };
  const double turnover = before.ledger.initial + std::abs(before.ledger.cell_work);
  // Rounding alone: of a thousand overlaps and, in mixed precision, of the motion that is left.
  EXPECT_NEAR(gap(after), gap(before), 1e-12 * turnover);
  EXPECT_EQ(after.energy.kinetic, 0);
  EXPECT_GT(after.ledger.quenched, before.ledger.quenched);
  EXPECT_EQ(now.simulation().cell().rate, Triangle{});
}

/// A run of nothing but a minimizer with calls of 200 evaluations, from a packing on.
struct Search {
  std::unique_ptr<Simulation> simulation;
  Observation now;
  RestWatch watch;
  Minimize minimize;

  Search(const Protocol& protocol, const Packing& from, const std::string& saved)
      : simulation(make_simulation(model_of(protocol, from), from)),
        now(*simulation, backbone_threshold(law_of(protocol))),
        watch(protocol.rest, Rhythm(0.1)),
        minimize(watch, 200) {
    minimize.restore(saved);
  }

  /// Goes on until the search ends, or has had so many calls.
  void go(int calls) {
    while (calls > 0) {
      simulation->advance(minimize.next(now.step()) - now.step());
      if (!minimize.due(now)) continue;
      minimize.fire(now);
      --calls;
      if (minimize.next(now.step()) > now.step() + 1) return;
    }
  }
};

// A search goes on as if it had not been stopped between two of its calls.
TEST(Minimize, GoesOnInTheMiddleOfASearch) {
  Protocol protocol = frictionless();
  protocol.minimizer = false;
  protocol.steps = 20'000;
  const Packing start = jam(spheres(300), protocol, 1).packing;
  Search whole(protocol, start, "");
  whole.go(1000);
  ASSERT_GT(whole.minimize.evaluations(), 600) << "several calls";
  for (int calls : {1, 2}) {
    Search first(protocol, start, "");
    first.go(calls);
    EXPECT_EQ(first.minimize.evaluations(), 200 * calls);
    Search second(protocol, first.now.packing(), first.minimize.saved());
    second.go(1000);
    EXPECT_EQ(second.minimize.saved(), whole.minimize.saved());
    EXPECT_EQ(state_hash(second.now.packing()), state_hash(whole.now.packing()));
  }
}

}  // namespace
}  // namespace furnas
