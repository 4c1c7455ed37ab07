#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/parallel_invoke.h>
#include <tbb/task_arena.h>

#include <chrono>
#include <mutex>
#include <set>
#include <string_view>
#include <thread>

#include "engine/base/parallel.h"
#include "engine/events/flip.h"
#include "engine/events/limits.h"
#include "engine/events/renew_order.h"
#include "engine/state/fingerprint.h"
#include "tests/engine/support/compaction.h"
#include "tests/engine/support/dice.h"
#include "tests/engine/support/release_machine.h"
#include "tests/engine/support/same_packing.h"
#include "tests/engine/support/setups.h"

namespace furnas {
namespace {

/// A gas that is squeezed and sheared until it flips: the cell is too heavy to stop its shear.
Packing tilting_gas(std::int64_t large) {
  Packing p = test::hasty_gas(large);
  const double edge = p.cell.edges.xx;
  p.cell.edges.xy = 0.45 * edge;
  p.cell.edges.yz = -0.5 * edge;
  p.cell.rate = {-0.008, -0.008, -0.008, -0.004, 0.001, 0.008};
  return p;
}

/// The state after a run with a flip and a renewed order in memory, and how it came about.
struct Outcome {
  Packing end;
  std::int64_t flips, builds;
};

struct Job {
  std::int64_t large = 20;  ///< with 64 times as many small ones
  int steps = 500;
};

Outcome run(int threads, Execution execution = Execution::automatic, const Job& job = {}) {
  Model model = test::hasty_model(0.3);
  model.barostat.inertia = 1e6;
  const auto simulation = make_simulation(model, tilting_gas(job.large), threads, execution);
  Observation now(*simulation, 3);
  Events events;
  events.push_back(std::make_unique<Flip>(100));
  events.push_back(std::make_unique<RenewOrder>(250));
  events.push_back(std::make_unique<Budget>(job.steps));
  EXPECT_EQ(compact(now, events), Verdict::budget);
  return {simulation->packing(), static_cast<const Flip&>(*events.front()).count(),
          simulation->neighbours().builds};
}

/// The run on one thread; all others must equal it.
const Outcome& alone() {
  static const Outcome outcome = run(1, Execution::in_order);
  return outcome;
}

/// Lets a test have more threads than the machine.
class Threads : public testing::Test {
  tbb::global_control more_{tbb::global_control::max_allowed_parallelism, 17};
};

// Guards the other tests: the run flips, builds lists, and is dense and sliding at its end.
TEST_F(Threads, TheRunIsLively) {
  EXPECT_EQ(alone().flips, 1);
  EXPECT_GT(alone().builds, 10);
  EXPECT_GT(alone().end.contacts.size(), 500u);
  EXPECT_GT(alone().end.fraction_filled(), 0.4);
  EXPECT_GT(alone().end.size(), 4 * 256u);
}

// T51: any number of threads, through a flip.
TEST_F(Threads, AnyNumberGivesTheSameBits) {
  for (int threads : {2, 3, 5, 8, 16})
    EXPECT_TRUE(test::same_packing(run(threads).end, alone().end)) << threads;
  EXPECT_TRUE(test::same_packing(run(5, Execution::in_order).end, alone().end));
}

// T51: arenas that get fewer workers than they have places.
TEST_F(Threads, MissingWorkersChangeNoBit) {
  for (std::size_t workers : {1, 3}) {
    const tbb::global_control fewer(tbb::global_control::max_allowed_parallelism, workers);
    for (int places : {2, 8})
      EXPECT_TRUE(test::same_packing(run(places).end, alone().end)) << workers << places;
  }
}

// T51: two simulations at once, of different sizes, begun inside somebody else's arena.
TEST_F(Threads, SimulationsSideBySideDoNotMeet) {
  tbb::task_arena outer(3);
  Packing first;
  Packing second;
  outer.execute([&] { tbb::parallel_invoke([&] { first = run(2).end; }, [&] { second = run(5).end; }); });
  EXPECT_TRUE(test::same_packing(first, alone().end));
  EXPECT_TRUE(test::same_packing(second, alone().end));
}

/// Delays threads at random while it lives: before every fourth piece of a loop on average, up to 50
/// microseconds, on each thread by dice of its own.
class Delays {
 public:
  explicit Delays(std::uint64_t seed) {
    seed_ = seed;
    threads_.clear();
    pieces_ = 0;
    detail::before_piece = &delay;
  }
  ~Delays() { detail::before_piece = nullptr; }
  Delays(const Delays&) = delete;
  Delays& operator=(const Delays&) = delete;

  /// Threads that have taken pieces, and pieces taken.
  static std::size_t threads() { return threads_.size(); }
  static std::int64_t pieces() { return pieces_; }

 private:
  static void delay() {
    thread_local test::Dice dice(seed_ + std::hash<std::thread::id>{}(std::this_thread::get_id()));
    ++pieces_;
    {
      const std::lock_guard lock(mutex_);
      threads_.insert(std::this_thread::get_id());
    }
    if (dice.below(4) != 0) return;
    const auto until = std::chrono::steady_clock::now() + std::chrono::microseconds(dice.below(50));
    while (std::chrono::steady_clock::now() < until) std::this_thread::yield();
  }

  inline static std::uint64_t seed_;
  inline static std::mutex mutex_;
  inline static std::set<std::thread::id> threads_;
  inline static std::atomic<std::int64_t> pieces_;
};

// T51: threads that are held up at random before the pieces of every loop of every phase. Nearly
// all phases are a chain (tests/engine/step_test.cpp); which thread does what, and when, is all that is left
// to chance. The packing is so large that even the loops over rows have many pieces.
TEST_F(Threads, DelaysChangeNoBit) {
  constexpr Job large{.large = 80, .steps = 150};
  const Outcome expected = run(1, Execution::in_order, large);
  EXPECT_GT(expected.builds, 3);
  EXPECT_GT(expected.end.contacts.size(), 500u);
  for (int threads : {3, 8}) {
    const Delays delays(static_cast<std::uint64_t>(threads));
    EXPECT_TRUE(test::same_packing(run(threads, Execution::automatic, large).end, expected.end)) << threads;
    EXPECT_GT(Delays::pieces(), 5000);
    EXPECT_GT(Delays::threads(), 1u);
  }
}

/// The bits of a release, where they were made: g++ 12, glibc 2.36, x86-64. Whoever changes a law, the step
/// or an order of sums changes these hashes, and says so in the notes of the release.
class Release : public testing::Test {
 protected:
  void SetUp() override {
    if (const std::string differs = test::difference_from_release_machine(); !differs.empty())
      GTEST_SKIP() << differs;
  }
};

// Nothing here but sums, products, quotients and square roots, which IEEE 754 prescribes bit for bit.
TEST_F(Release, ARunInAFixedCellHasThisHash) {
  test::Dice dice(1);
  std::vector<Ball> balls;
  for (int k = 0; k < 300; ++k)
    balls.push_back({.position = {dice.between(0, 8), dice.between(0, 8), dice.between(0, 8)},
                     .velocity = dice.vector(0.1),
                     .spin = dice.vector(0.1),
                     .radius = k < 10 ? 1.0 : 0.5});
  const Packing start = packing_of({8, 8, 8, 1, -2, 3}, balls);
  EXPECT_EQ(hex(state_hash(after(model_of<HookeSynchronized>({.friction = 0.3}), start, 500))),
            "1ec228a366fbd20a");
  EXPECT_EQ(hex(state_hash(after(model_of<HookeHistory>({.friction = 0.3}), start, 500))),
            "c27406349490e4be");
  EXPECT_EQ(hex(state_hash(after(model_of<Frictionless<false>>({}), start, 500))), "c82c011546cb8a1e");
}

// The drag of a cell that moves needs an exponential function, which C libraries round as they like.
TEST_F(Release, ARunInAMovingCellHasThisHash) { EXPECT_EQ(hex(state_hash(alone().end)), "fa65fe5cd8fe9d1f"); }

}  // namespace
}  // namespace furnas
