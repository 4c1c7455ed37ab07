#include "cases/program/run/progress.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <sstream>
#include <thread>

#include "tests/engine/events/resting_story.h"

namespace furnas {
namespace {

TEST(LeftText, TellsTheRangeAndTheCap) {
  EXPECT_EQ(left_text({}, 3600, 1), "time left not known yet, at most 60 min");
  EXPECT_EQ(left_text(StepsLeft{6, 12, 30}, 3600, 1), "left about 12 s (6 s to 30 s), at most 60 min");
  EXPECT_EQ(left_text(StepsLeft{6, 12, INFINITY}, 3600, 1), "left about 12 s (6 s or more), at most 60 min");
  EXPECT_EQ(left_text(StepsLeft{60, INFINITY, INFINITY}, 3600, 0.5), "left 2 min or more, at most 2.0 h");
}

TEST(LiveLines, AreOneLineOfAFile) {
  std::ostringstream out;
  LiveLines lines(out, false);
  lines.show({"step 1", "stress 2"});
  lines.show({"step 2"});
  lines.clear();
  EXPECT_EQ(out.str(), "step 1   stress 2\nstep 2\n");
}

/// Whatever is shown next has the terminal as it was before the first.
TEST(LiveLines, AreTakenAwayBeforeTheNext) {
  std::ostringstream out;
  LiveLines lines(out, true);
  const std::string wide(70, 'x');  // of 80 letters, or as many as the terminal has
  lines.show({wide, wide, wide, wide});
  const std::string shown = out.str();
  const auto breaks = std::count(shown.begin(), shown.end(), '\n');
  out.str("");
  lines.say("done");
  const std::string back = breaks > 0 ? "\033[" + std::to_string(breaks) + "A" : "";
  EXPECT_EQ(out.str(), back + "\r\033[Jdone\n");
  out.str("");
  lines.clear();
  EXPECT_EQ(out.str(), "");
}

/// A search for a minimum takes minutes between two steps in a large packing; lines tell how far it is.
TEST(Progress, TellsOfTheMinimizerBetweenItsPeriods) {
  RestingStory story([](std::int64_t) { return Unrest{}; });
  std::ostringstream out;
  LiveLines lines(out, true);  // a line every half second
  std::atomic<bool> attention = false;
  Progress progress(lines, story.watch, 0, 100'000, attention);
  ASSERT_TRUE(progress.heeds_attention());
  const auto wait = [&] {
    for (int n = 0; n < 1000 && !attention; ++n) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    EXPECT_TRUE(attention.exchange(false)) << "the event asks for attention when a line is due";
  };
  wait();
  EXPECT_FALSE(progress.due(story.now)) << "at the first step there is no rate yet";
  story.simulation.advance(1, nullptr);
  EXPECT_FALSE(progress.due(story.now)) << "between two looks there is no news";
  story.now.count_evaluations(7);
  ASSERT_TRUE(progress.due(story.now));
  progress.fire(story.now);
  EXPECT_THAT(out.str(), testing::HasSubstr("minimizing: 7 evaluations"));
  EXPECT_THAT(out.str(), testing::Not(testing::HasSubstr("balance"))) << "the criteria are those of a look";
  out.str("");
  wait();
  EXPECT_FALSE(progress.due(story.now));
  story.simulation.advance(story.watch.period() - 1, nullptr);
  story.watch.look(story.now);
  ASSERT_TRUE(progress.due(story.now));
  progress.fire(story.now);
  EXPECT_THAT(out.str(), testing::Not(testing::HasSubstr("minimizing"))) << "the search is over";
  EXPECT_THAT(out.str(), testing::HasSubstr("balance"));
}

TEST(Progress, TellsWhenThePressureChanges) {
  RestingStory story([](std::int64_t) { return Unrest{}; });
  std::ostringstream out;
  LiveLines lines(out, false);
  std::atomic<bool> attention = false;
  Progress progress(lines, story.watch, 0, 100'000, attention);
  const auto look = [&] {
    story.simulation.advance(story.watch.period(), nullptr);
    progress.due(story.now);
  };
  look();
  EXPECT_EQ(out.str(), "") << "the first pressure is that of the case";
  Barostat bath = story.simulation.model().barostat;
  bath.pressure = 3e-5;
  story.simulation.set_bath(bath);
  for (int n = 0; n < 2; ++n) look();
  EXPECT_EQ(out.str(), "p_a is 3e-05 after 0.0001, from step " + std::to_string(2 * story.watch.period()) +
                           " on; phi " + std::to_string(story.now.measures().phi).substr(0, 7) + "\n");
}

TEST(Progress, TellsItsStepToThoseWhoReadItsLines) {
  RestingStory story([](std::int64_t) { return Unrest{}; });
  std::ostringstream out;
  LiveLines lines(out, false);
  std::atomic<bool> attention = false;
  Progress progress(lines, story.watch, 0, 100'000, attention);
  EXPECT_FALSE(step_of_last_line(out.str()));
  for (int n = 1; n <= 2; ++n) {
    story.simulation.advance(story.watch.period(), nullptr);
    story.watch.look(story.now);
    progress.fire(story.now);
    EXPECT_EQ(step_of_last_line(out.str()), n * story.watch.period());
  }
}

}  // namespace
}  // namespace furnas
