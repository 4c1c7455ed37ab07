#include "engine/step.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "tests/engine/support/compaction.h"

namespace furnas {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Pair;

/// Whether a phase waits for an earlier one, or for one that does.
bool comes_after(const StepGraph& step, std::size_t phase, std::size_t earlier) {
  const auto waits = step.waits_for(phase);
  return std::any_of(waits.begin(), waits.end(),
                     [&](std::size_t k) { return k == earlier || comes_after(step, k, earlier); });
}

// Forces need the list, the list the places, the places the cell, the cell the forces: one chain. Beside it
// the contacts may be put on a new list, and their work may be booked.
TEST(Step, OfAMovingCellIsAChainButForTwoPairs) {
  const auto simulation = make_simulation(test::hasty_model(0.3), test::hasty_gas(2));
  const StepGraph& step = simulation->graph();
  const std::vector<std::string> titles = step.titles();
  EXPECT_THAT(titles, ElementsAre("kick the cell", "book the drag", "stretch the cell", "kick and drift",
                                  "stretch the cell", "add the displacement", "measure the displacement",
                                  "bin the particles", "pick up the contacts", "search the pairs",
                                  "put down the contacts", "watch the inner list", "contact forces",
                                  "book the contacts", "gather and kick", "book the drag", "kick the cell"));
  EXPECT_THAT(step.waits_for(0), IsEmpty());
  std::vector<std::pair<std::string, std::string>> at_once;
  for (std::size_t k = 0; k < titles.size(); ++k)
    for (std::size_t earlier = 0; earlier < k; ++earlier)
      if (!comes_after(step, k, earlier)) at_once.emplace_back(titles[earlier], titles[k]);
  EXPECT_THAT(at_once, ElementsAre(Pair("put down the contacts", "watch the inner list"),
                                   Pair("book the contacts", "gather and kick")));
}

TEST(Step, OfAFixedCellDoesNotTouchTheCell) {
  Model model = test::hasty_model(0.3);
  model.barostat.freedom = CellFreedom::fixed;
  const auto simulation = make_simulation(model, test::hasty_gas(2));
  const Cell before = simulation->cell();
  simulation->advance(50);
  EXPECT_EQ(simulation->cell(), before);
  const std::vector<std::string> titles = simulation->graph().titles();
  EXPECT_EQ(std::count(titles.begin(), titles.end(), "stretch the cell"), 0);
  EXPECT_EQ(std::count(titles.begin(), titles.end(), "kick the cell"), 0);
}

TEST(Step, IsDrawnWithTheNamesOfWhatItTouches) {
  const auto simulation = make_simulation(test::hasty_model(0.3), test::hasty_gas(2));
  std::ostringstream dot;
  simulation->graph().write_dot(dot);
  for (const std::string& title : simulation->graph().titles())
    EXPECT_THAT(dot.str(), HasSubstr("<b>" + title + "</b>"));
  for (const char* name :
       {"cell", "particles", "loads", "pairs", "rows", "contact state", "image", "stress", "displacement"})
    EXPECT_THAT(dot.str(), HasSubstr(name));
}

TEST(Step, StopsWhenToldTo) {
  const auto simulation = make_simulation(test::hasty_model(0.3), test::hasty_gas(2));
  const std::atomic<bool> stop = true;
  simulation->advance(100, &stop);
  EXPECT_EQ(simulation->step(), 0);
  const std::atomic<bool> go_on = false;
  simulation->advance(100, &go_on);
  EXPECT_EQ(simulation->step(), 100);
}

}  // namespace
}  // namespace furnas
