#include "engine/graph/step_graph.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <sstream>
#include <stdexcept>
#include <thread>

#include "engine/base/parallel.h"
#include "tests/engine/support/dice.h"
#include "tests/engine/support/property.h"

namespace furnas {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

struct Whole {
  int part{};
  int other{};
};

void read(const int&) {}
void write(int&) {}
void copy(const int& from, int& to) { to = from; }
void increment(int& value) { ++value; }
void write_whole(Whole&) {}
void by_value(int) {}

TEST(StepGraph, ReadersOfTheSameThingDoNotWait) {
  int a = 0;
  StepGraph step;
  step.phase("one", read, a);
  step.phase("two", read, a);
  step.phase("three", by_value, a);
  EXPECT_THAT(step.waits_for(1), IsEmpty());
  EXPECT_THAT(step.waits_for(2), IsEmpty());
}

TEST(StepGraph, EachConflictIsAnEdge) {
  int a = 0;
  StepGraph step;
  step.phase("write", write, a);
  step.phase("read after write", read, a);
  step.phase("write after read", write, a);
  step.phase("write after write", write, a);
  EXPECT_THAT(step.waits_for(0), IsEmpty());
  EXPECT_THAT(step.waits_for(1), ElementsAre(0));
  EXPECT_THAT(step.waits_for(2), ElementsAre(1));
  EXPECT_THAT(step.waits_for(3), ElementsAre(2));
}

TEST(StepGraph, WhatTouchesDifferentThingsDoesNotWait) {
  int a = 0;
  int b = 0;
  int c = 0;
  StepGraph step;
  step.phase("a", write, a);
  step.phase("b", write, b);
  step.phase("b to c", copy, b, c);
  step.phase("a again", write, a);
  EXPECT_THAT(step.waits_for(1), IsEmpty());
  EXPECT_THAT(step.waits_for(2), ElementsAre(1));
  EXPECT_THAT(step.waits_for(3), ElementsAre(0));
}

TEST(StepGraph, AWriterWaitsForAllReaders) {
  int a = 0;
  int b = 0;
  int c = 0;
  StepGraph step;
  step.phase("a to b", copy, a, b);
  step.phase("a to c", copy, a, c);
  step.phase("write a", write, a);
  EXPECT_THAT(step.waits_for(2), ElementsAre(0, 1));
}

TEST(StepGraph, EdgesThatFollowFromOthersAreLeftOut) {
  int a = 0;
  int b = 0;
  StepGraph step;
  step.phase("write a", write, a);
  step.phase("a to b", copy, a, b);
  step.phase("b to a", copy, b, a);  // conflicts with both, and the second waits for the first
  EXPECT_THAT(step.waits_for(2), ElementsAre(1));
}

TEST(StepGraph, AStructAndItsMemberAreTheSameThing) {
  Whole whole;
  StepGraph step;
  step.phase("whole", write_whole, whole);
  step.phase("part", write, whole.part);
  step.phase("other", write, whole.other);
  step.phase("whole again", write_whole, whole);
  EXPECT_THAT(step.waits_for(1), ElementsAre(0));
  EXPECT_THAT(step.waits_for(2), ElementsAre(0));
  EXPECT_THAT(step.waits_for(3), ElementsAre(1, 2));
}

TEST(StepGraph, AGatedPhaseRunsWhenItsFlagIsSetAtItsTurn) {
  bool open = false;
  int runs = 0;
  StepGraph step;
  step.phase(
      "open the gate", +[](bool& gate, const int& n) { gate = n % 2 == 0; }, open, runs);
  step.phase_when(open, "gated", increment, runs);
  EXPECT_THAT(step.waits_for(1), ElementsAre(0));
  Workers(2).run([&] {
    step.run_in_order();
    EXPECT_EQ(runs, 1);
    step.run_in_order();
    EXPECT_EQ(runs, 1);
    runs = 4;
    step.run_as_graph();
    EXPECT_EQ(runs, 5);
    step.run_as_graph();
    EXPECT_EQ(runs, 5);
  });
}

TEST(StepGraph, KeepsTheTimeOfEachPhaseWhenAsked) {
  bool open = false;
  int runs = 0;
  StepGraph step;
  step.phase(
      "sleep", +[](int&) { std::this_thread::sleep_for(std::chrono::milliseconds(2)); }, runs);
  step.phase_when(open, "gated", increment, runs);
  std::vector<PhaseTime> times{{1, 1}};
  step.keep_times(&times);
  const auto begin = std::chrono::steady_clock::now();
  step.run_in_order();
  open = true;
  Workers(2).run([&] { step.run_as_graph(); });
  const std::chrono::duration<double> both_runs = std::chrono::steady_clock::now() - begin;
  ASSERT_EQ(times.size(), 2U);
  EXPECT_EQ(times[0].runs, 2);
  EXPECT_EQ(times[1].runs, 1);
  EXPECT_GE(times[0].seconds, 4e-3);
  EXPECT_LE(times[0].seconds + times[1].seconds, both_runs.count());
  step.keep_times(nullptr);
  step.run_in_order();
  EXPECT_EQ(times[0].runs, 2);
  EXPECT_EQ(runs, 2);
}

// The phase throws when its neighbour has already told their successor that it is done: a graph that
// remembers that would start the successor too early in the next run.
TEST(StepGraph, RunsAgainAfterAPhaseHasThrown) {
  const tbb::global_control more(tbb::global_control::max_allowed_parallelism, 4);
  int a = 0;
  int b = 0;
  int sum = 0;
  static std::atomic<bool> neighbour_done;
  neighbour_done = false;
  bool broken = true;
  StepGraph step;
  step.phase(
      "breaks",
      +[](const bool& throws, int& value) {
        for (int wait = 0; wait < 5000 && !neighbour_done; ++wait)
          std::this_thread::sleep_for(std::chrono::milliseconds(1));
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
        if (throws) throw std::runtime_error("broken");
        value += 10;
      },
      broken, a);
  step.phase(
      "neighbour",
      +[](int& value) {
        ++value;
        neighbour_done = true;
      },
      b);
  step.phase(
      "sum", +[](const int& x, const int& y, int& to) { to = x + y; }, a, b, sum);
  EXPECT_THAT(step.waits_for(2), ElementsAre(0, 1));
  Workers(4).run([&] {
    EXPECT_THROW(step.run_as_graph(), std::runtime_error);
    broken = false;
    for (int n = 1; n < 4; ++n) {
      a = b = 0;
      step.run_as_graph();
      EXPECT_EQ(sum, 11);
    }
  });
}

TEST(StepGraph, RunsInOrderOutsideOfWorkers) {
  std::vector<int> order;
  StepGraph step;
  step.phase(
      "one", +[](std::vector<int>& list) { list.push_back(1); }, order);
  step.phase(
      "two", +[](std::vector<int>& list) { list.push_back(2); }, order);
  step.run_as_graph();
  EXPECT_THAT(order, ElementsAre(1, 2));
}

TEST(StepGraph, GrowsAndMovesAfterItHasRun) {
  int a = 0;
  StepGraph first;
  StepGraph second;
  Workers(2).run([&] {
    first.phase("one", increment, a);
    first.run_as_graph();
    first.phase("two", increment, a);
    first.run_as_graph();
    second = std::move(first);
    second.run_as_graph();
  });
  EXPECT_EQ(a, 5);
  EXPECT_THAT(second.titles(), ElementsAre("one", "two"));
}

TEST(StepGraph, DrawsTitlesNamesAndEdges) {
  int a = 0;
  int b = 0;
  bool flag = true;
  StepGraph step;
  step.name(a, "apples");
  step.name(b, "pears");
  step.phase("pick", write, a);
  step.phase_when(flag, "swap", copy, a, b);
  std::ostringstream dot;
  step.write_dot(dot);
  EXPECT_THAT(dot.str(), HasSubstr("digraph"));
  EXPECT_THAT(dot.str(), HasSubstr("<b>pick</b><br/><font point-size=\"10\">writes apples</font>"));
  EXPECT_THAT(dot.str(), HasSubstr("reads apples"));
  EXPECT_THAT(dot.str(), HasSubstr("writes pears"));
  EXPECT_THAT(dot.str(), HasSubstr("p0 -> p1;"));
  EXPECT_THAT(dot.str(), HasSubstr("dashed"));
}

/// One thing of the random step, and when phases touched it.
struct Thing {
  std::uint64_t value = 1;
};

void mix(const Thing& from, Thing& to) {
  std::this_thread::yield();
  to.value = to.value * 6364136223846793005u + from.value;
}
void mix_two(const Thing& a, const Thing& b, Thing& to) {
  std::this_thread::yield();
  to.value = (to.value ^ a.value) * 6364136223846793005u + b.value;
}

// Each phase depends on all that it reads, so any order that the edges should forbid shows.
TEST(StepGraph, TheGraphGivesWhatTheOrderGives) {
  const tbb::global_control more(tbb::global_control::max_allowed_parallelism, 8);
  Workers workers(4);
  EXPECT_TRUE(test::holds(100, [&] {
    test::Dice dice(test::any_seed());
    std::vector<Thing> things(2 + dice.below(5));
    const auto any = [&]() -> Thing& { return things[dice.below(things.size())]; };
    StepGraph step;
    const std::uint64_t phases = 1 + dice.below(20);
    for (std::uint64_t k = 0; k < phases; ++k) {
      if (dice.chance(0.5))
        step.phase("mix", mix, any(), any());
      else
        step.phase("mix two", mix_two, any(), any(), any());
    }
    for (int n = 0; n < 5; ++n) step.run_in_order();
    std::vector<std::uint64_t> expected;
    for (Thing& thing : things) expected.push_back(std::exchange(thing.value, 1));
    workers.run([&] {
      for (int n = 0; n < 5; ++n) step.run_as_graph();
    });
    for (std::size_t k = 0; k < things.size(); ++k) RC_ASSERT(things[k].value == expected[k]);
  }));
}

// The edges are the fewest that order every conflict: taken together they reach each of them, and none
// follows from two others.
TEST(StepGraph, TheEdgesAreTheTransitiveReductionOfTheConflicts) {
  EXPECT_TRUE(test::holds(300, [] {
    test::Dice dice(test::any_seed());
    std::vector<Thing> things(2 + dice.below(4));
    StepGraph step;
    const std::size_t phases = 1 + dice.below(15);
    std::vector<std::pair<std::size_t, std::size_t>> accesses;  // read, written
    for (std::size_t k = 0; k < phases; ++k) {
      accesses.emplace_back(dice.below(things.size()), dice.below(things.size()));
      step.phase("mix", mix, things[accesses[k].first], things[accesses[k].second]);
    }
    std::vector<std::vector<bool>> before(phases, std::vector<bool>(phases));
    for (std::size_t k = 0; k < phases; ++k)
      for (std::size_t edge : step.waits_for(k)) {
        RC_ASSERT(edge < k);
        before[k][edge] = true;
        for (std::size_t n = 0; n < phases; ++n) before[k][n] = before[k][n] || before[edge][n];
      }
    for (std::size_t k = 0; k < phases; ++k) {
      for (std::size_t n = 0; n < k; ++n) {
        const auto [read_n, write_n] = accesses[n];
        const auto [read_k, write_k] = accesses[k];
        const bool conflict = write_n == read_k || write_n == write_k || read_n == write_k;
        if (conflict) RC_ASSERT(before[k][n]);
      }
      for (std::size_t edge : step.waits_for(k)) {
        const auto [read_n, write_n] = accesses[edge];
        const auto [read_k, write_k] = accesses[k];
        RC_ASSERT(write_n == read_k || write_n == write_k || read_n == write_k);
        for (std::size_t other : step.waits_for(k)) RC_ASSERT(!before[other][edge]);
      }
    }
  }));
}

}  // namespace
}  // namespace furnas
