#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cfenv>
#include <ctime>
#include <limits>
#include <vector>

#include "engine/base/parallel.h"
#include "engine/graph/step_graph.h"
#include "engine/monitor/measure.h"
#include "tests/engine/support/compaction.h"
#include "tests/engine/support/dice.h"
#include "tests/engine/support/meeting.h"
#include "tests/engine/support/same_packing.h"
#include "tests/engine/support/setups.h"

namespace furnas {
namespace {

/// A dilute gas in a cell that deforms steadily, its velocities and spins of the size `speed`.
Packing slow_gas(double speed) {
  Packing p = test::hasty_gas(20);
  test::Dice dice(1);
  for (Vec3<double>& v : p.velocity) v = dice.vector(speed);
  for (Vec3<double>& w : p.spin) w = dice.vector(speed);
  p.cell.rate = {1e-4, 1e-4, -1e-4, 1e-4, 1e-4, 1e-4};
  return p;
}

Model driven_model() {
  Model model = test::hasty_model(0.3);
  model.barostat.inertia = 1e300;
  return model;
}

Packing end_of_slow_run(int threads, Execution execution) {
  const tbb::global_control more(tbb::global_control::max_allowed_parallelism, 16);
  const auto simulation = make_simulation(driven_model(), slow_gas(1e-310), threads, execution);
  simulation->advance(20);
  return simulation->packing();
}

// T64: velocities of 1e-310, which processors keep with ever fewer digits, are taken for zero on every
// thread.
TEST(Denormals, AreZeroOnEveryThread) {
  const Packing expected = end_of_slow_run(1, Execution::in_order);
  std::size_t at_rest = 0;
  for (const Vec3<double>& v : expected.velocity) {
    EXPECT_FALSE(std::fpclassify(v.x) == FP_SUBNORMAL || std::fpclassify(v.y) == FP_SUBNORMAL ||
                 std::fpclassify(v.z) == FP_SUBNORMAL);
    at_rest += v == Vec3<double>{};
  }
  EXPECT_GT(at_rest, expected.size() / 2);  // the others have touched
  for (int threads : {1, 2, 5, 8})
    for (Execution execution : {Execution::in_order, Execution::as_graph})
      EXPECT_TRUE(test::same_packing(end_of_slow_run(threads, execution), expected)) << threads;
}

/// Time of the processor that some steps take [s].
double seconds(double speed) {
  const auto simulation = make_simulation(driven_model(), slow_gas(speed));
  const std::clock_t start = std::clock();
  simulation->advance(40);
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

// T64: they cost what other numbers cost, within a factor of 2 (before: 43). The fastest of several runs,
// taken in turn, for other programs disturb some.
TEST(NightlyDenormals, CostWhatOtherNumbersCost) {
  for (double speed : {1e-310, 1e-320, 1e-160}) {
    double usual = std::numeric_limits<double>::infinity();
    double tiny = usual;
    for (int n = 0; n < 6; ++n) {
      usual = std::min(usual, seconds(1e-5));
      tiny = std::min(tiny, seconds(speed));
    }
    EXPECT_LT(tiny, 2 * usual) << speed;
  }
}

/// While it lives, this thread rounds as told.
class Rounding {
 public:
  explicit Rounding(int mode) : before_(std::fegetround()) { std::fesetround(mode); }
  ~Rounding() { std::fesetround(before_); }

 private:
  int before_;
};

// A program that has set another way to round, before the workers were made or after, gets the same bits, and
// finds its own way again.
TEST(Rounding, IsThatOfTheWorkersNotOfTheCaller) {
  const Packing start = test::hasty_gas(20);
  const Model model = test::hasty_model(0.3);
  const auto end = [&](int before, int then, int threads) {
    const Rounding during_making(before);
    const auto simulation = make_simulation(model, start, threads);
    const Rounding during_work(then);
    simulation->advance(300);
    EXPECT_EQ(std::fegetround(), then);
    const Rounding back(FE_TONEAREST);
    return simulation->packing();
  };
  const Packing expected = end(FE_TONEAREST, FE_TONEAREST, 1);
  ASSERT_GT(expected.contacts.size(), 10u);
  for (int threads : {1, 2, 5}) {
    EXPECT_TRUE(test::same_packing(end(FE_TONEAREST, FE_UPWARD, threads), expected)) << threads;
    EXPECT_TRUE(end(FE_DOWNWARD, FE_DOWNWARD, threads).velocity == expected.velocity) << threads;
  }
}

/// What a thread does with numbers.
struct Habits {
  int rounding = -1;
  double tiny = 1;  ///< half of a number below which there are only denormals
};

void show_habits(const test::Meeting& meeting, Habits& mine) {
  volatile double smallest = std::numeric_limits<double>::min();
  mine.rounding = std::fegetround();
  mine.tiny = meeting.attend() ? smallest / 2 : 1;
}

// Two phases that wait for each other run on two threads, whose arithmetic is that of the workers.
TEST(Rounding, IsThatOfTheWorkersOnEachThreadThatRunsAPhase) {
  const tbb::global_control more(tbb::global_control::max_allowed_parallelism, 4);
  const Rounding of_the_caller(FE_UPWARD);
  const test::Meeting meeting(2);
  Habits habits[2];
  StepGraph step;
  for (Habits& mine : habits) step.phase("show habits", show_habits, meeting, mine);
  Workers(2).run([&] { step.run_as_graph(); });
  for (const Habits& mine : habits) {
    EXPECT_EQ(mine.rounding, FE_TONEAREST);
    EXPECT_EQ(mine.tiny, 0);
  }
}

constexpr int wrong = FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW;

/// Exceptions of floating point that `work` raises on this thread.
template <class Work>
int raised(Work&& work) {
  std::feclearexcept(FE_ALL_EXCEPT);
  work();
  return std::fetestexcept(wrong);
}

// Guards the next test: what a worker raises reaches the caller.
TEST(FloatingPoint, AnInvalidOperationOfAWorkerIsSeen) {
  Workers workers(1);
  volatile double zero = 0;
  volatile double result = 0;
  EXPECT_EQ(raised([&] { workers.run([&] { result = zero / zero; }); }), FE_INVALID);
  EXPECT_EQ(raised([&] { workers.run([&] { result = 1 / zero; }); }), FE_DIVBYZERO);
  EXPECT_EQ(raised([&] { workers.run([&] { result = zero + 1; }); }), 0);
}

// No step of a run divides by zero, makes a number that is none, or overflows: neither from the first touch
// to a packing, nor where nothing touches or nothing presses, nor in what is read off the packing.
TEST(FloatingPoint, NoStepDividesByZero) {
  struct Run {
    Model model;
    Packing start;
    int steps;
  };
  std::vector<Run> runs;
  for (double friction : {0.0, 0.3})
    for (bool legacy : {false, true})
      runs.push_back({test::hasty_model(friction, legacy), test::hasty_gas(5), 1500});
  Run tiny_pressure{test::hasty_model(0.3), test::hasty_gas(5), 100};
  tiny_pressure.model.barostat.pressure = 1e-12;
  Run no_pressure = tiny_pressure;
  no_pressure.model.barostat.pressure = 0;
  Run alone{test::hasty_model(0.3), packing_of(cube(8), {{}}), 100};
  runs.insert(runs.end(), {tiny_pressure, no_pressure, alone});
  for (std::size_t n = 0; n < runs.size(); ++n) {
    std::unique_ptr<Simulation> simulation;
    ASSERT_EQ(raised([&] { simulation = make_simulation(runs[n].model, runs[n].start); }), 0) << "run " << n;
    for (int step = 0; step < runs[n].steps; ++step)
      ASSERT_EQ(raised([&] { simulation->advance(1); }), 0) << "run " << n << ", step " << step;
    ASSERT_EQ(raised([&] { measure(simulation->packing(), 3); }), 0) << "run " << n;
    if (n < 4) {
      EXPECT_GT(simulation->packing().contacts.size(), 100u) << "run " << n;
    }
  }
}

// The same pair of spheres, alone at each of 70 places of the list and of memory: a compiler that took
// several rows at a time and the rest one by one, and contracted only some, would show in the bits.
TEST(FloatingPoint, APairHasTheSameBitsAtEachPlaceOfALoop) {
  constexpr int pairs = 70;
  constexpr double distance = 4;
  const double length = 512;  // so that the distances between pairs are exact
  std::vector<Ball> balls;
  for (int k = 0; k < pairs; ++k) {
    const Vec3<double> at{distance * (k + 1), 8, 16};
    balls.push_back({.position = at, .velocity = {0.1, 0.2, 0.3}, .spin = {0.3, 0.1, -0.2}});
    balls.push_back({.position = at + Vec3<double>{0.5, 0.5625, 0.4375}, .velocity = {-0.2, 0.1, 0.1}});
  }
  for (const Model& model :
       {model_of<HookeSynchronized>({.friction = 0.3}), model_of<HookeHistory>({.friction = 0.3}),
        model_of<Frictionless<false>>({}), model_of<Frictionless<true>>({})})
    for (int count : {1, 2, 3, 5, 8, 13, pairs}) {
      const Packing p =
          after(model, packing_of(cube(length), {balls.begin(), balls.begin() + 2 * count}), 20);
      ASSERT_EQ(p.contacts.size(), static_cast<std::size_t>(count));
      for (std::size_t k = 2; k < p.size(); ++k) {
        ASSERT_TRUE(test::same_bits(p.velocity[k], p.velocity[k % 2])) << k << " of " << p.size();
        ASSERT_TRUE(test::same_bits(p.spin[k], p.spin[k % 2])) << k << " of " << p.size();
        ASSERT_TRUE(test::same_bits(p.force[k], p.force[k % 2])) << k << " of " << p.size();
      }
    }
}

// -ffp-contract=off: a product that is rounded before it is added leaves nothing of the square below.
TEST(FloatingPoint, ProductsAreRoundedBeforeTheyAreAdded) {
  volatile double x = 1 + 0x1p-30;
  const double a = x;
  volatile double square = a * a;
  const double b = square;
  EXPECT_EQ(a * a - b, 0);
#ifdef __FAST_MATH__
  FAIL() << "arithmetic must not be reordered";
#endif
}

}  // namespace
}  // namespace furnas
