#include "engine/protocol/run.h"

#include <gtest/gtest.h>

#include <limits>
#include <memory>

#include "engine/base/require.h"
#include "engine/events/limits.h"
#include "engine/start/mixture.h"
#include "tests/engine/support/same_packing.h"

namespace furnas {
namespace {

Packing gas() { return dilute_start({.large = 100, .start_fraction = 0.2, .seed = 3}); }

/// A hundred spheres that jam within seconds.
Protocol hasty() {
  Protocol protocol;
  protocol.pressures = {1e-2};
  protocol.drag = 0;
  protocol.time_step = 0.02;
  protocol.rest = {.stress_error = 1e-2,
                   .force_imbalance = 1e-2,
                   .kinetic_energy = 1e-8,
                   .strain_drift = 1e-4,
                   .window = 20};
  protocol.steps = 200'000;
  return protocol;
}

TEST(Jam, GivesAPackingAtRestUnderItsPressure) {
  const Protocol protocol = hasty();
  const Jam end = jam(gas(), protocol);
  ASSERT_EQ(end.verdict, Verdict::jammed);
  ASSERT_TRUE(end.phi_J());
  EXPECT_EQ(*end.phi_J(), end.packing.fraction_filled());
  EXPECT_NEAR(end.measures.pressure, 1e-2, 1e-2 * protocol.rest.stress_error);
  EXPECT_LT(end.rest.force_imbalance, protocol.rest.force_imbalance);
  ASSERT_EQ(end.reached.size(), 1u);
  EXPECT_EQ(end.reached[0].phi, *end.phi_J());
  // Under a pressure of 1e-2 a packing is denser than at jamming, and less than filled.
  EXPECT_GT(*end.phi_J(), 0.55);
  EXPECT_LT(*end.phi_J(), 0.75);
}

// Rattlers fly on after a single quench, since the contacts that were closed push them off again. The packing
// stays what it is.
TEST(Jam, FinalQuenchesStopTheRattlers) {
  Protocol protocol = hasty();
  const Jam one = jam(gas(), protocol);
  protocol.rest.final_quenches = 20;
  const Jam many = jam(gas(), protocol);
  ASSERT_EQ(one.verdict, Verdict::jammed);
  ASSERT_EQ(many.verdict, Verdict::jammed);
  EXPECT_GT(one.measures.kinetic_energy, 0);
  EXPECT_LT(many.measures.kinetic_energy, 1e-4 * one.measures.kinetic_energy);
  EXPECT_LT(many.rest.force_imbalance, one.rest.force_imbalance);
  EXPECT_NEAR(*many.phi_J(), *one.phi_J(), 1e-4);
}

TEST(Jam, HasTheSameBitsForAnyThreads) {
  Protocol protocol = hasty();
  protocol.steps = 3000;
  const Jam one = jam(gas(), protocol, 1), two = jam(gas(), protocol, 2);
  EXPECT_EQ(one.verdict, Verdict::budget);
  EXPECT_FALSE(one.phi_J());
  EXPECT_TRUE(test::same_packing(one.packing, two.packing));
}

TEST(Jam, TakesOnePressureAfterTheOther) {
  Protocol protocol = hasty();
  protocol.pressures = {2e-2, 1e-2};
  const Jam end = jam(gas(), protocol);
  ASSERT_EQ(end.verdict, Verdict::jammed);
  ASSERT_EQ(end.reached.size(), 2u);
  EXPECT_EQ(end.reached[0].pressure, 2e-2);
  EXPECT_EQ(end.reached[1].pressure, 1e-2);
  EXPECT_GT(end.reached[0].phi, end.reached[1].phi) << "a higher pressure squeezes the same packing more";
}

/// Ends the run at a step, as a signal would.
class EndsAt final : public Event {
 public:
  explicit EndsAt(std::int64_t step) : step_(step) {}
  const char* name() const override { return "ends at"; }
  std::int64_t next(std::int64_t step) const override {
    return step < step_ ? step_ : std::numeric_limits<std::int64_t>::max();
  }
  std::optional<Verdict> fire(Observation&) override { return Verdict::interrupted; }

 private:
  std::int64_t step_;
};

// What a stopped run hands on is all that the next one needs: bits, looks, counts.
TEST(ProtocolRun, GoesOnAsIfItHadNotBeenStopped) {
  Protocol protocol = hasty();
  protocol.steps = 7'600;
  ProtocolRun whole(protocol, gas(), 1);
  whole.begin();
  EXPECT_EQ(whole.go().verdict, Verdict::budget);

  ProtocolRun first(protocol, gas(), 1);
  Onlookers onlookers;
  onlookers.limits.push_back(std::make_unique<EndsAt>(7300));
  first.begin(std::move(onlookers));
  EXPECT_EQ(first.go().verdict, Verdict::interrupted);
  const RunState state = first.state();
  ProtocolRun second(protocol, first.take_packing(), 2, state);
  second.begin();
  EXPECT_EQ(second.go().verdict, Verdict::budget);

  EXPECT_TRUE(test::same_packing(second.now().packing(), whole.now().packing()));
  EXPECT_EQ(second.state().events, whole.state().events);
  EXPECT_EQ(second.state().watch.window.size(), whole.state().watch.window.size());
  EXPECT_EQ(second.flips(), whole.flips());
  EXPECT_EQ(second.quenches(), whole.quenches());
}

TEST(ProtocolRun, RefusesWhatCannotBeRun) {
  EXPECT_THROW(ProtocolRun(hasty(), Packing{}, 1), InputError);
  Protocol without_pressure = hasty();
  without_pressure.pressures.clear();
  EXPECT_THROW(ProtocolRun(without_pressure, gas(), 1), InputError);
  EXPECT_THROW(ProtocolRun(hasty(), gas(), 0), ContractError);
}

TEST(ProtocolRun, ACollapseIsAnOutcome) {
  Protocol protocol = hasty();
  protocol.pressures = {0.1};
  protocol.contact.normal_damping = 0;
  protocol.time_step_absolute = 0.9;
  ProtocolRun run(protocol, gas(), 1);
  run.begin();
  const Outcome outcome = run.go();
  EXPECT_EQ(outcome.verdict, Verdict::diverged);
  EXPECT_NE(outcome.fault, "");
  EXPECT_FALSE(outcome.is_sound);
}

// K dt^2 + 2 C dt < 4 for a sphere with many dashpots: strong ones need a short step.
TEST(AutomaticStep, IsStableForAnyDamping) {
  for (const double friction : {0.0, 0.3})
    for (const double damping : {2.0, 5.0, 10.0, 50.0}) {
      Protocol protocol;
      protocol.contact = {.normal_damping = damping, .friction = friction};
      protocol.pressures = {1e-3};
      protocol.steps = 20'000;
      const Jam end = jam(gas(), protocol);
      EXPECT_NE(end.verdict, Verdict::diverged) << damping << ' ' << friction << ": " << end.fault;
      EXPECT_GT(end.measures.phi, 0.5) << damping << ' ' << friction;
    }
}

// By the criterion of the paper, at so low a pressure that the first few contacts hardly move.
TEST(Jam, AGasIsNoPackingHoweverSlow) {
  Protocol protocol;
  protocol.pressures = {1e-9};
  protocol.rest = {.kinetic_energy_alone = true, .kinetic_energy = 1e-3, .window = 20};
  protocol.steps = 20'000;
  const Jam end = jam(dilute_start({.large = 100, .start_fraction = 0.3}), protocol);
  EXPECT_EQ(end.verdict, Verdict::budget);
  EXPECT_EQ(end.rest.waiting_for, "a backbone");
}

}  // namespace
}  // namespace furnas
