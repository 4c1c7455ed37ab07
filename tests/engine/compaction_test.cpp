#include "engine/compaction.h"

#include <gtest/gtest.h>

#include <chrono>
#include <string>
#include <thread>

#include "engine/base/require.h"
#include "engine/events/limits.h"
#include "tests/engine/fake_simulation.h"
#include "tests/engine/support/graph_packing.h"

namespace furnas {
namespace {

Packing tetrahedron(std::int64_t) { return packing_of_graph(4, clique(4)); }

/// Writes down when it is asked and when it happens.
struct Diary : Event {
  Diary(std::string& log, char letter, std::int64_t period) : log_(log), letter_(letter), period_(period) {}

  const char* name() const override { return "diary"; }
  std::int64_t next(std::int64_t step) const override { return next_multiple(step, period_); }
  bool due(Observation& now) override {
    if (!happens(now)) log_ += '(' + entry(now) + ')';
    return happens(now);
  }
  bool heeds_attention() const override { return heeds; }
  std::optional<Verdict> fire(Observation& now) override {
    log_ += entry(now);
    if (then) then(now);
    return now.step() == ends_at ? std::optional(ends_with) : std::nullopt;
  }
  std::string entry(const Observation& now) const { return letter_ + std::to_string(now.step()) + ' '; }

  std::function<bool(Observation&)> happens = [](Observation&) { return true; };
  std::function<void(Observation&)> then;
  bool heeds = false;
  std::int64_t ends_at = -1;
  Verdict ends_with = Verdict::budget;

 private:
  std::string& log_;
  char letter_;
  std::int64_t period_;
};

/// A run of made-up events.
struct Trial {
  Diary& add(char letter, std::int64_t period) {
    events.push_back(std::make_unique<Diary>(log, letter, period));
    return static_cast<Diary&>(*events.back());
  }
  Verdict go(std::atomic<bool>* attention = nullptr) { return compact(now, events, attention); }

  std::string log;
  FakeSimulation simulation{tetrahedron};
  Observation now{simulation, 3};
  Events events;
};

TEST(NextMultiple, LiesAfterTheStep) {
  EXPECT_EQ(next_multiple(0, 10), 10);
  EXPECT_EQ(next_multiple(9, 10), 10);
  EXPECT_EQ(next_multiple(10, 10), 20);
  EXPECT_EQ(next_multiple(7, 1), 8);
}

TEST(SavedCount, IsACountOrNothing) {
  EXPECT_EQ(saved_count(""), 0);
  EXPECT_EQ(saved_count("17"), 17);
  for (const char* saved : {"-1", "1.5", " 1", "1 ", "one"})
    EXPECT_THROW(saved_count(saved), InputError) << saved;
}

TEST(Compact, EventsOfAStepHappenInTheOrderOfTheTable) {
  Trial run;
  run.add('b', 6);
  run.add('a', 2);
  run.add('c', 3).ends_at = 6;
  EXPECT_EQ(run.go(), Verdict::budget);
  EXPECT_EQ(run.log, "a2 c3 a4 b6 a6 c6 ");
  EXPECT_EQ(run.simulation.step(), 6);
}

TEST(Compact, TheFirstAnswerEndsIt) {
  Trial run;
  run.add('a', 5);
  Diary& second = run.add('b', 5);
  second.ends_at = 10;
  second.ends_with = Verdict::jammed;
  Diary& third = run.add('c', 5);
  third.ends_at = 10;
  EXPECT_EQ(run.go(), Verdict::jammed);
  EXPECT_EQ(run.log, "a5 b5 c5 a10 b10 ");
}

/// An event that is not due is left alone, and asked again when it next may be.
TEST(Compact, WhatIsNotDueDoesNotHappen) {
  Trial run;
  run.add('a', 4).happens = [](Observation& now) { return now.step() == 8; };
  run.add('b', 12).ends_at = 12;
  run.go();
  EXPECT_EQ(run.log, "(a4 )a8 (a12 )b12 ");
}

/// Steps from an event to the next are taken in one go: nothing looks up in between.
TEST(Compact, JumpsToTheNextEvent) {
  struct Jumps : FakeSimulation {
    using FakeSimulation::FakeSimulation;
    void advance(std::int64_t steps, const std::atomic<bool>* stop) override {
      jumps.push_back(steps);
      FakeSimulation::advance(steps, stop);
    }
    std::vector<std::int64_t> jumps;
  };
  Jumps simulation(tetrahedron);
  Observation now(simulation, 3);
  std::string log;
  Events events;
  events.push_back(std::make_unique<Diary>(log, 'a', 10));
  events.push_back(std::make_unique<Diary>(log, 'b', 7));
  static_cast<Diary&>(*events.back()).ends_at = 21;
  compact(now, events);
  EXPECT_EQ(simulation.jumps, (std::vector<std::int64_t>{7, 3, 4, 6, 1}));
}

TEST(Compact, NeedsAnEvent) {
  Trial run;
  EXPECT_THROW(run.go(), ContractError);
}

/// A call for attention asks those who heed it, at once and once; what happens to the state by the table
/// of steps must not depend on it.
TEST(Compact, AttentionConcernsThoseWhoHeedIt) {
  Trial run;
  std::atomic<bool> attention{false};
  run.add('a', 5).then = [&](Observation& now) { attention = now.step() == 5; };
  run.add('b', 100);
  run.add('c', 100).heeds = true;
  run.add('d', 15).ends_at = 15;
  run.go(&attention);
  EXPECT_EQ(run.log, "a5 c5 a10 a15 d15 ");
  EXPECT_FALSE(attention);
}

TEST(Compact, AttentionIsHeardAmongTheSteps) {
  struct Endless final : FakeSimulation {
    using FakeSimulation::FakeSimulation;
    void advance(std::int64_t, const std::atomic<bool>* asked) override {
      while (!*asked) std::this_thread::sleep_for(std::chrono::microseconds(100));
    }
  } simulation(tetrahedron);
  Observation now(simulation, 3);
  std::atomic<bool> attention{false};
  std::atomic<bool> stop{false};
  Events events;
  events.push_back(std::make_unique<Budget>(1'000'000'000'000));
  events.push_back(std::make_unique<Interrupted>(stop));
  const std::jthread caller([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    stop = true;
    attention = true;
  });
  EXPECT_EQ(compact(now, events, &attention), Verdict::interrupted);
}

TEST(Observation, IsTakenOnceAStepAndOnlyWhenAsked) {
  FakeSimulation simulation(tetrahedron);
  Observation now(simulation, 3);
  EXPECT_EQ(simulation.packings_taken, 0);
  EXPECT_EQ(now.packing().size(), 4u);
  EXPECT_EQ(now.measures().contacts, 6);
  now.packing();
  now.measures();
  EXPECT_EQ(simulation.packings_taken, 1);
  simulation.advance(3, nullptr);
  EXPECT_EQ(simulation.packings_taken, 1);
  EXPECT_EQ(now.measures().step, 3);
  EXPECT_EQ(now.packing().step, 3);
  EXPECT_EQ(simulation.packings_taken, 2);
}

TEST(Observation, SeesWhatReplacedThePacking) {
  FakeSimulation simulation(tetrahedron);
  Observation now(simulation, 3);
  EXPECT_EQ(now.measures().rattlers[1].backbone, 4);
  now.replace(packing_of_graph(5, clique(5)));
  EXPECT_EQ(now.packing().size(), 5u);
  EXPECT_EQ(now.measures().contacts, 10);
  EXPECT_EQ(simulation.packings_taken, 2);
}

TEST(Observation, MeasuresWithItsThresholdAndTheListsBuilt) {
  FakeSimulation simulation(tetrahedron);
  for (int threshold : {2, 3, 4})
    EXPECT_EQ(Observation(simulation, threshold).measures().backbone_threshold, threshold);
  EXPECT_EQ(Observation(simulation, 3).measures().rebuilds, 17);
}

TEST(Verdict, IsSpelledAsInFiles) {
  EXPECT_STREQ(to_string(Verdict::jammed), "jammed");
  EXPECT_STREQ(to_string(Verdict::budget), "budget");
  EXPECT_STREQ(to_string(Verdict::diverged), "diverged");
  EXPECT_STREQ(to_string(Verdict::interrupted), "interrupted");
}

}  // namespace
}  // namespace furnas
