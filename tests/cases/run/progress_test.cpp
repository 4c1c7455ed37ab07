#include "cases/program/run/progress.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

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

}  // namespace
}  // namespace furnas
