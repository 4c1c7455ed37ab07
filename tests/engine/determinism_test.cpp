#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <string>

#include "engine/kernels/kernels.h"
#include "tests/engine/support/compaction.h"
#include "tests/engine/support/same_packing.h"

namespace furnas {
namespace {

struct Case {
  const char* name;
  double friction;
  bool legacy;
  std::int64_t large;
  std::int64_t steps;
  Precision precision = Precision::full;
};

/// The hasty model in the precision of a case.
Model model_for(const Case& c) {
  Model model = test::hasty_model(c.friction, c.legacy);
  model.precision = c.precision;
  return model;
}

struct End {
  Packing end;
  std::int64_t builds;
};

class Determinism : public ::testing::TestWithParam<Case> {
 protected:
  End run(const Model& with, int threads = 1, Execution execution = Execution::in_order) const {
    // More threads than the machine has, so that several really work.
    const tbb::global_control more(tbb::global_control::max_allowed_parallelism, 16);
    const auto simulation = make_simulation(with, start, threads, execution);
    simulation->advance(steps);
    return {simulation->packing(), simulation->neighbours().builds};
  }

  const Packing start = test::hasty_gas(GetParam().large);
  const Model model = model_for(GetParam());
  const std::int64_t steps = GetParam().steps;
};

// Guards the other tests: bits that agree say nothing about a run in which nothing happens. Longer runs
// begin with this one.
TEST_P(Determinism, TheRunHasSomethingToDisagreeAbout) {
  constexpr std::int64_t lively = 700;
  const auto simulation = make_simulation(model, start);
  simulation->advance(lively);
  const Packing end = simulation->packing();
  EXPECT_GE(steps, lively);
  EXPECT_GT(start.size(), 4 * 256u);
  EXPECT_GT(simulation->neighbours().builds, 10);
  EXPECT_LT(simulation->neighbours().builds, lively / 3);
  EXPECT_GT(end.fraction_filled(), 1.5 * start.fraction_filled());
  EXPECT_GT(end.contacts.size(), 1000u);
  EXPECT_GT(std::abs(end.cell.edges.xy), 1e-3);
  std::size_t sliding = 0;
  std::size_t crossed = 0;
  for (const Contact& c : end.contacts) sliding += c.sliding;
  for (const Image& image : end.image) crossed += image != Image{};
  EXPECT_GT(crossed, 0u);
  if (GetParam().friction > 0) {
    EXPECT_GT(sliding, 100u);
    EXPECT_LT(sliding, end.contacts.size() - 100);
  }
}

TEST_P(Determinism, TheSameBitsForAnyThreadsAndSchedule) {
  const Packing expected = run(model).end;
  for (int threads : {1, 2, 3, 5, 8})
    for (Execution execution : {Execution::in_order, Execution::as_graph})
      EXPECT_TRUE(test::same_packing(run(model, threads, execution).end, expected))
          << threads << " threads, " << (execution == Execution::as_graph ? "as graph" : "in order");
}

TEST_P(Determinism, TheSameBitsOnEveryInstructionSet) {
  struct Restore {
    InstructionSet before = instruction_set();
    ~Restore() { choose(before); }
  } const restore;
  const Packing expected = run(model).end;
  std::string lacks;
  for (InstructionSet set : {InstructionSet::scalar, InstructionSet::avx2, InstructionSet::avx512}) {
    choose(set);
    if (instruction_set() == set)
      EXPECT_TRUE(test::same_packing(run(model, 2, Execution::as_graph).end, expected)) << to_string(set);
    else
      lacks += std::string(" ") + to_string(set);
  }
  if (!lacks.empty()) GTEST_SKIP() << "compared without what this processor lacks:" << lacks;
}

TEST_P(Determinism, TheSameBitsForAnySkin) {
  const End automatic = run(model);
  for (double skin : {0.0, 0.01, 0.1, 0.5}) {
    Model other = model;
    other.skin = skin;
    const End r = run(other);
    EXPECT_TRUE(test::same_state(r.end, automatic.end)) << "skin " << skin;
    if (skin == 0)
      EXPECT_EQ(r.builds, steps + 1);  // a list without room is worn in every step
    else
      EXPECT_NE(r.builds, automatic.builds);
  }
}

TEST_P(Determinism, TheSameBitsWhenThePackingIsTakenOutAndPutBack) {
  const Packing expected = run(model).end;
  for (std::int64_t every : {std::int64_t{1}, std::int64_t{7}, std::min<std::int64_t>(1000, steps / 2)}) {
    auto simulation = make_simulation(model, start);
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
  const auto simulation = make_simulation(model, start);
  simulation->advance(steps);
  const Packing before = simulation->packing();
  simulation->load(before);
  EXPECT_TRUE(test::same_packing(simulation->packing(), before));
}

std::string name_of_case(const ::testing::TestParamInfo<Case>& test) { return test.param.name; }

INSTANTIATE_TEST_SUITE_P(Gas, Determinism,
                         ::testing::Values(Case{"Smooth", 0, false, 20, 700},
                                           Case{"Rough", 0.3, false, 20, 700},
                                           Case{"Legacy", 0.3, true, 20, 700},
                                           Case{"SmoothMixed", 0, false, 20, 700, Precision::mixed},
                                           Case{"RoughMixed", 0.3, false, 20, 700, Precision::mixed},
                                           Case{"LegacyMixed", 0.3, true, 20, 700, Precision::mixed}),
                         name_of_case);
INSTANTIATE_TEST_SUITE_P(Nightly, Determinism,
                         ::testing::Values(Case{"Smooth", 0, false, 60, 5000},
                                           Case{"Rough", 0.3, false, 60, 5000}),
                         name_of_case);

}  // namespace
}  // namespace furnas
