#include "engine/events/limits.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "engine/base/require.h"
#include "engine/start/mixture.h"
#include "tests/engine/fake_simulation.h"
#include "tests/engine/support/graph_packing.h"

namespace furnas {
namespace {

using testing::HasSubstr;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

Packing gas(double start_fraction = 0.2) {
  return dilute_start({.large = 60, .start_fraction = start_fraction});
}

Model model_at(double pressure) {
  Model model;
  model.law = HookeSynchronized{{.friction = 0.3}};
  model.barostat.pressure = pressure;
  model.barostat.inertia = 60;
  return model;
}

/// What an InputError says that loading a packing throws; empty if it throws none.
std::string refusal(const Packing& packing) {
  try {
    make_simulation(model_at(1e-4), packing);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

TEST(Loading, RefusesWhatIsNoNumberByTheParticle) {
  EXPECT_EQ(refusal(gas()), "");
  for (double bad : {nan, infinity, -infinity}) {
    for (auto list : {&Packing::velocity, &Packing::spin, &Packing::force, &Packing::torque}) {
      Packing p = gas();
      (p.*list)[41].y = bad;
      EXPECT_THAT(refusal(p), HasSubstr("of particle 42 is not finite"));
    }
  }
  Packing p = gas();
  p.cell.edges.xz = nan;
  EXPECT_THAT(refusal(p), HasSubstr("an edge of the cell"));
  p = gas();
  p.cell.edges.zz = 0;
  EXPECT_THAT(refusal(p), HasSubstr("the cell has no volume"));
  p = gas();
  p.fraction[7] = p.fraction[3];
  EXPECT_THAT(refusal(p), HasSubstr("particle 4 and particle 8 have the same centre"));
  for (std::size_t k = 0; k < p.size(); ++k) p.labels.id.push_back(100 + static_cast<std::int64_t>(k));
  EXPECT_THAT(refusal(p), HasSubstr("particle 103 and particle 107 have the same centre")) << "ids of a file";
}

TEST(Budget, EndsAtItsStepAndNotBefore) {
  for (std::int64_t last : {0, 1, 7, 2500}) {
    FakeSimulation simulation([](std::int64_t) { return packing_of_graph(1, {}); });
    Observation now(simulation, 3);
    Events events;
    events.push_back(std::make_unique<Budget>(last));
    EXPECT_EQ(compact(now, events), Verdict::budget);
    EXPECT_EQ(now.step(), last);
  }
}

/// A run that goes on with its steps already spent takes none.
TEST(Budget, SpentBeforeItBegins) {
  FakeSimulation simulation([](std::int64_t) { return packing_of_graph(1, {}); });
  simulation.advance(500, nullptr);
  Observation now(simulation, 3);
  Events events;
  events.push_back(std::make_unique<Budget>(100));
  EXPECT_EQ(compact(now, events), Verdict::budget);
  EXPECT_EQ(now.step(), 500);
}

TEST(Interrupted, EndsWhenAskedTo) {
  FakeSimulation simulation([](std::int64_t) { return packing_of_graph(1, {}); });
  Observation now(simulation, 3);
  std::atomic<bool> stop{false};
  Events events;
  events.push_back(std::make_unique<Interrupted>(stop));
  events.push_back(std::make_unique<Budget>(5000));
  EXPECT_EQ(compact(now, events), Verdict::budget);
  EXPECT_EQ(now.step(), 5000);
  stop = true;
  EXPECT_EQ(compact(now, events), Verdict::budget);  // no step is left in which it could be asked
  events.back() = std::make_unique<Budget>(9000);
  EXPECT_EQ(compact(now, events), Verdict::interrupted);
  EXPECT_EQ(now.step(), 6000);
}

}  // namespace
}  // namespace furnas
