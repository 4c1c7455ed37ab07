#include "engine/events/monitor.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/base/require.h"
#include "engine/events/limits.h"
#include "tests/engine/fake_simulation.h"
#include "tests/engine/support/compaction.h"
#include "tests/engine/support/setups.h"

namespace furnas {
namespace {

using testing::HasSubstr;

/// How a run ends: the verdict's reason, what a step cannot do any more, or "budget".
std::string end_of_run(const Model& model, const Packing& start, std::int64_t steps = 5000) {
  const auto simulation = make_simulation(model, start);
  Observation now(*simulation, 3);
  Events events;
  events.push_back(std::make_unique<Monitor>());
  events.push_back(std::make_unique<Budget>(steps));
  try {
    return compact(now, events) == Verdict::diverged ? now.fault() : "budget";
  } catch (const NumericalFailure& failure) {
    return failure.what();
  }
}

std::string end_of_gas_at(double pressure) {
  Model model;
  model.law = HookeSynchronized{{.friction = 0.3}};
  model.barostat.pressure = pressure;
  model.barostat.inertia = 60;
  return end_of_run(model, dilute_start({.large = 60, .start_fraction = 0.2}));
}

/// A pressure like the stiffness of the spheres squeezes them into each other, a higher one collapses the
/// cell.
TEST(Monitor, EndsACollapseWithASentence) {
  EXPECT_THAT(end_of_gas_at(0.5),
              testing::AnyOf(HasSubstr("the spheres fill"), HasSubstr("have run into each other"),
                             HasSubstr("the balance of the energy")));
  for (double pressure : {10.0, 1e6})
    EXPECT_THAT(end_of_gas_at(pressure),
                testing::AnyOf(HasSubstr("the cell has collapsed"), HasSubstr("the spheres fill"),
                               HasSubstr("the edges of the cell are no numbers any more")));
}

/// Far above jamming and in motion; without its past, so that the energy is counted from here.
Packing squeezed_start() {
  Packing p = squeezed(0.1);
  p.order.clear();
  return p;
}

TEST(Monitor, LetsAGasBe) { EXPECT_EQ(end_of_gas_at(1e-12), "budget"); }

TEST(Monitor, LetsAPackingBe) {
  Model model = jammed_model();
  EXPECT_EQ(end_of_run(model, jammed()), "budget");
  EXPECT_EQ(end_of_run(model, squeezed_start()), "budget");
}

TEST(Monitor, SeesATimeStepThatLosesTheEnergy) {
  Model model = test::hasty_model(0.3);
  model.time_step *= 10;
  EXPECT_THAT(end_of_run(model, test::hasty_gas()),
              testing::AnyOf(HasSubstr("the balance of the energy misses"), HasSubstr("too long")));
}

/// What the monitor says of two looks, 1000 steps apart, at the jammed packing; `change` alters the second.
std::string second_look(const std::function<void(Packing&)>& change) {
  FakeSimulation simulation([&](std::int64_t step) {
    Packing p = jammed();
    if (step > 1000) change(p);
    return p;
  });
  simulation.model() = jammed_model();
  Observation now(simulation, 3);
  Monitor monitor;
  simulation.advance(1000, nullptr);
  EXPECT_FALSE(monitor.due(now)) << now.fault();
  simulation.advance(1000, nullptr);
  if (!monitor.due(now)) return {};
  EXPECT_EQ(monitor.fire(now), Verdict::diverged);
  return now.fault();
}

TEST(Monitor, SeesMomentumThatComesFromNowhere) {
  EXPECT_EQ(second_look([](Packing&) {}), "");
  const auto kicked = [](double speed) {
    return second_look([speed](Packing& p) { p.velocity[3].x += speed; });
  };
  // What double precision rounds in 1000 steps: velocities one by one, and the impulse of every contact.
  double impulse = 0;
  for (const Contact& c : jammed().contacts) impulse += norm(c.force) * jammed_model().time_step;
  const double noise = 1000 * 0x1p-53 * impulse / jammed().mass[3];
  EXPECT_EQ(kicked(noise), "");
  EXPECT_THAT(kicked(1e3 * noise), HasSubstr("the momentum of all particles has changed"));
}

TEST(Monitor, SeesAMissedContact) {
  EXPECT_THAT(second_look([](Packing& p) { p.contacts.erase(p.contacts.begin(), p.contacts.begin() + 300); }),
              HasSubstr("the neighbour list has missed the contact"));
}

TEST(Monitor, SeesALedgerThatDoesNotClose) {
  EXPECT_EQ(second_look([](Packing& p) { p.ledger.cell_work *= 1.02; }), "");
  EXPECT_THAT(second_look([](Packing& p) { p.ledger.losses.sliding += 0.2 * p.ledger.cell_work; }),
              HasSubstr("the balance of the energy misses 0."));
}

TEST(Monitor, RefusesAMemoryThatIsNone) {
  Monitor monitor;
  monitor.restore("");
  EXPECT_EQ(monitor.saved(), "");
  const std::string written = "0.10000000000000001 -2 1.5e-05 3 8 8 8 0 -0.5 0 12000 1";  // by furnas 0.2.0
  monitor.restore(written);
  EXPECT_EQ(monitor.saved(), written);
  for (const std::string& saved :
       {std::string("0.1 2"), written.substr(0, written.size() - 2), written + " 2", written + "x"})
    EXPECT_THROW(monitor.restore(saved), InputError) << saved;
}

/// Events that change the motion on purpose are no fault.
TEST(Monitor, TakesAPackingThatAnEventHasReplaced) {
  const auto simulation = make_simulation(jammed_model(), squeezed_start());
  Observation now(*simulation, 3);
  Monitor monitor;
  simulation->advance(10);
  EXPECT_FALSE(monitor.due(now)) << now.fault();
  Packing p = now.packing();
  p.velocity[3] = {};
  now.replace(p);
  simulation->advance(10);
  EXPECT_FALSE(monitor.due(now)) << now.fault();
}

}  // namespace
}  // namespace furnas
