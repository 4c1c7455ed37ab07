#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>

#include "engine/base/parallel.h"
#include "engine/graph/step_graph.h"
#include "tests/engine/support/dice.h"
#include "tests/engine/support/meeting.h"
#include "tests/engine/support/property.h"

namespace furnas {
namespace {

void hand_on(const int& from, int& to) { to = from; }
void count_up(int& value) { ++value; }
void meet(const test::Meeting& meeting, bool& met) { met = meeting.attend(); }

/// Lets a test have more threads than the machine.
class StepGraphOnThreads : public testing::Test {
  tbb::global_control more_{tbb::global_control::max_allowed_parallelism, 9};
};

// Each of two phases ends only when the other has begun.
TEST_F(StepGraphOnThreads, PhasesThatDoNotDependOnEachOtherRunAtOnce) {
  Workers workers(2);
  for (int n = 0; n < 20; ++n) {
    const test::Meeting meeting(2);
    bool a = false;
    bool b = false;
    StepGraph step;
    step.phase("a", meet, meeting, a);
    step.phase("b", meet, meeting, b);
    workers.run([&] { step.run_as_graph(); });
    ASSERT_TRUE(a && b);
  }
}

TEST_F(StepGraphOnThreads, AsManyPhasesRunAtOnceAsThereAreThreads) {
  constexpr int threads = 4;
  const test::Meeting meeting(threads);
  bool met[threads] = {};
  StepGraph step;
  for (bool& mine : met) step.phase("meet", meet, meeting, mine);
  Workers(threads).run([&] { step.run_as_graph(); });
  for (bool mine : met) EXPECT_TRUE(mine);
}

// The turn of the last phase comes while the first is running, and neither ends without the other.
TEST_F(StepGraphOnThreads, APhaseWhoseTurnComesBesideALongOneDoesNotWaitForIt) {
  Workers workers(2);
  for (int n = 0; n < 20; ++n) {
    const test::Meeting meeting(2);
    bool is_long = false;
    bool last = false;
    int before = 0;
    StepGraph step;
    step.phase("long", meet, meeting, is_long);
    step.phase("one", count_up, before);
    step.phase("two", count_up, before);
    step.phase(
        "last", +[](const test::Meeting& m, const int& turns, bool& met) { met = m.attend() && turns == 2; },
        meeting, before, last);
    workers.run([&] { step.run_as_graph(); });
    ASSERT_TRUE(is_long && last);
  }
}

/// The sum of the squares below 1000, by a loop of many pieces that begins when the other phase is there.
void sum_squares(const test::Meeting& meeting, std::int64_t& sum) {
  ASSERT_TRUE(meeting.attend());
  sum = ordered_sum<std::int64_t>(1000, 3, [](std::size_t begin, std::size_t end) {
    std::int64_t part = 0;
    for (std::size_t k = begin; k < end; ++k) part += static_cast<std::int64_t>(k * k);
    return part;
  });
}

TEST_F(StepGraphOnThreads, LoopsOfPhasesThatRunAtOnceDoTheirWork) {
  for (int threads : {2, 3, 8}) {
    Workers workers(threads);
    workers.run([&] {
      for (int n = 0; n < 200; ++n) {
        const test::Meeting meeting(2);
        std::int64_t a = 0;
        std::int64_t b = 0;
        StepGraph step;
        step.phase("a", sum_squares, meeting, a);
        step.phase("b", sum_squares, meeting, b);
        step.run_as_graph();
        ASSERT_EQ(a, 332833500);
        ASSERT_EQ(b, 332833500);
      }
    });
  }
}

TEST_F(StepGraphOnThreads, NothingRunsAnyMoreWhenTheCallerLearnsOfAFailure) {
  const test::Meeting meeting(2);
  int slow = 0;
  int fails = 0;
  int after = 0;
  StepGraph step;
  step.phase(
      "slow",
      +[](const test::Meeting& m, int& value) {
        m.attend();
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        ++value;
      },
      meeting, slow);
  step.phase(
      "fails",
      +[](const test::Meeting& m, int&) {
        m.attend();
        throw std::runtime_error("failed");
      },
      meeting, fails);
  step.phase("after", hand_on, fails, after);
  step.phase("after both", hand_on, slow, after);
  after = -1;
  Workers(2).run([&] {
    EXPECT_THROW(step.run_as_graph(), std::runtime_error);
    EXPECT_EQ(slow, 1);
    EXPECT_EQ(after, -1);
  });
}

/// A thing that notices who is at it at once.
struct Guarded {
  mutable std::atomic<int> readers = 0;
  mutable std::atomic<int> writers = 0;
  inline static std::atomic<int> clashes = 0;
  inline static std::atomic<int> inside = 0;  ///< phases
  inline static std::atomic<int> together = 0;
};

void read_and_write(const Guarded& from, Guarded& to) {
  const bool same = &from == &to;
  if (++Guarded::inside > 1) ++Guarded::together;
  if (!same) ++from.readers;
  ++to.writers;
  for (int n = 0; n < 3; ++n) {
    std::this_thread::yield();
    if (to.writers != 1 || to.readers != 0 || (!same && from.writers != 0)) ++Guarded::clashes;
  }
  --to.writers;
  if (!same) --from.readers;
  --Guarded::inside;
}

TEST_F(StepGraphOnThreads, PhasesThatDependOnEachOtherNeverRunAtOnce) {
  Guarded::clashes = Guarded::together = 0;
  Workers workers(4);
  EXPECT_TRUE(test::holds(100, [&] {
    test::Dice dice(test::any_seed());
    std::vector<Guarded> things(2 + dice.below(8));
    const auto any = [&]() -> Guarded& { return things[dice.below(things.size())]; };
    StepGraph step;
    const std::uint64_t phases = 1 + dice.below(20);
    for (std::uint64_t k = 0; k < phases; ++k) step.phase("read and write", read_and_write, any(), any());
    workers.run([&] {
      for (int n = 0; n < 5; ++n) step.run_as_graph();
    });
    RC_ASSERT(Guarded::clashes == 0);
    RC_ASSERT(Guarded::inside == 0);
  }));
  EXPECT_GT(Guarded::together, 100);  // else the test would not have noticed
}

}  // namespace
}  // namespace furnas
