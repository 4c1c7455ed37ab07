#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "tests/engine/support/compaction.h"
#include "tests/engine/support/same_packing.h"

namespace furnas {
namespace {

constexpr std::int64_t steps = 700;

struct Outcome {
  Packing end;
  std::int64_t builds;
};

Outcome run(const Model& model, int threads = 1, Schedule schedule = Schedule::in_order) {
  // More threads than the machine has, so that several really work.
  const tbb::global_control more(tbb::global_control::max_allowed_parallelism, 16);
  const auto simulation = make_simulation(model, test::hasty_gas(), threads, schedule);
  simulation->advance(steps);
  return {simulation->packing(), simulation->builds()};
}

class Determinism : public ::testing::TestWithParam<double> {
 protected:
  const Model model = test::hasty_model(GetParam());
};

// Guards the other tests: bits that agree say nothing about a run in which nothing happens.
TEST_P(Determinism, TheRunHasSomethingToDisagreeAbout) {
  const Packing start = test::hasty_gas();
  const Outcome r = run(model);
  EXPECT_GT(start.size(), 4 * 256u);
  EXPECT_GT(r.builds, 10);
  EXPECT_LT(r.builds, steps / 3);
  EXPECT_GT(r.end.fraction_filled(), 1.5 * start.fraction_filled());
  EXPECT_GT(r.end.contacts.size(), 1000u);
  EXPECT_GT(std::abs(r.end.cell.edges.xy), 1e-3);
  std::size_t sliding = 0;
  std::size_t crossed = 0;
  for (const Contact& c : r.end.contacts) sliding += c.sliding;
  for (const Image& image : r.end.image) crossed += image != Image{};
  EXPECT_GT(crossed, 0u);
  if (GetParam() > 0) {
    EXPECT_GT(sliding, 100u);
    EXPECT_LT(sliding, r.end.contacts.size() - 100);
  }
}

TEST_P(Determinism, TheSameBitsForAnyThreadsAndSchedule) {
  const Packing expected = run(model).end;
  for (int threads : {1, 2, 3, 5, 8})
    for (Schedule schedule : {Schedule::in_order, Schedule::as_graph})
      EXPECT_TRUE(test::same_packing(run(model, threads, schedule).end, expected))
          << threads << " threads, " << (schedule == Schedule::as_graph ? "as graph" : "in order");
}

TEST_P(Determinism, TheSameBitsForAnySkin) {
  const Outcome automatic = run(model);
  for (double skin : {0.0, 0.01, 0.1, 0.5}) {
    Model other = model;
    other.skin = skin;
    const Outcome r = run(other);
    EXPECT_TRUE(test::same_packing(r.end, automatic.end)) << "skin " << skin;
    if (skin == 0)
      EXPECT_EQ(r.builds, steps + 1);  // a list without room is worn in every step
    else
      EXPECT_NE(r.builds, automatic.builds);
  }
}

TEST_P(Determinism, TheSameBitsWhenThePackingIsTakenOutAndPutBack) {
  const Packing expected = run(model).end;
  for (std::int64_t every : {1, 7, 100}) {
    auto simulation = make_simulation(model, test::hasty_gas());
    while (simulation->step() < steps) {
      simulation->advance(std::min(every, steps - simulation->step()));
      if (every == 7)
        simulation = make_simulation(model, simulation->packing());
      else
        simulation->load(simulation->packing());
    }
    EXPECT_TRUE(test::same_packing(simulation->packing(), expected)) << "every " << every << " steps";
  }
}

TEST_P(Determinism, LoadingChangesNoBit) {
  const auto simulation = make_simulation(model, test::hasty_gas());
  simulation->advance(steps);
  const Packing before = simulation->packing();
  simulation->load(before);
  EXPECT_TRUE(test::same_packing(simulation->packing(), before));
}

INSTANTIATE_TEST_SUITE_P(Friction, Determinism, ::testing::Values(0.0, 0.3),
                         [](const auto& test) { return test.param > 0 ? "Rough" : "Smooth"; });

}  // namespace
}  // namespace furnas
