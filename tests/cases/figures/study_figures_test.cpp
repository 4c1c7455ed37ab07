#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/cases/process.h"
#include "tests/cases/study_tables.h"
#include "tests/io/packings.h"

namespace furnas {
namespace {

namespace fs = std::filesystem;

/// The figures that the pages of results show are those that `furnas figures` draws from the tables beside
/// them, byte for byte. The pictures (PNG) are not kept there.
TEST(StudyFigures, FollowFromTheTablesBesideThem) {
  const TemporaryFolder folder;
  const fs::path drawn = folder / "figures";
  std::vector<std::string> command{"figures"};
  for (const fs::path& table : study_tables()) command.push_back(table.string());
  command.insert(command.end(), {"--out", drawn.string()});
  const Ending drawing = ending_of(command);
  ASSERT_EQ(drawing.code, 0) << drawing.out;
  std::size_t kept = 0;
  for (const auto& file : fs::directory_iterator(study_folder() / "figures")) {
    EXPECT_EQ(content(file.path()), content(drawn / file.path().filename())) << file.path();
    ++kept;
  }
  const auto is_kept = [](const fs::directory_entry& file) { return file.path().extension() != ".png"; };
  EXPECT_EQ(std::count_if(fs::directory_iterator(drawn), fs::directory_iterator(), is_kept), kept);
}

/// Whether `furnas plot` with these options draws the figure in a folder of findings from its table.
void expect_drawn(const char* finding, const std::string& figure, const std::vector<std::string>& options) {
  const fs::path table = fs::path(FURNAS_SOURCE_DIR) / "docs/results/findings" / finding;
  const TemporaryFolder folder;
  std::vector<std::string> command{"plot", table.string()};
  command.insert(command.end(), options.begin(), options.end());
  command.insert(command.end(), {"--out", (folder / "drawn.svg").string()});
  const Ending drawing = ending_of(command);
  ASSERT_EQ(drawing.code, 0) << drawing.out;
  EXPECT_EQ(content(folder / "drawn.svg"), content(table / figure));
}

TEST(StudyFigures, OfTheSecondTransitionFollowsFromItsTable) {
  expect_drawn("second_transition", "small_rattlers.svg",
               {"--x", "pressure", "--y", "small_rattlers_4", "--by", "small_fraction"});
}

TEST(StudyFigures, OfTheLeftBranchFollowsFromItsTable) {
  expect_drawn("left_branch", "phi.svg", {"--x", "mass_exponent", "--y", "phi", "--by", "winding"});
}

}  // namespace
}  // namespace furnas
