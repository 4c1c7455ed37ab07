#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/cases/process.h"
#include "tests/io/packings.h"

namespace furnas {
namespace {

namespace fs = std::filesystem;

/// The folders of tables in a folder, in the order in which docs/results/study.md names them.
std::vector<std::string> table_folders(const fs::path& study) {
  std::vector<std::string> folders;
  for (const char* name :
       {"mono", "mono_10000", "alpha_2", "alpha_3", "alpha_5", "alpha_10", "alpha_20", "alpha_20_thin"})
    if (fs::exists(study / name)) folders.push_back((study / name).string());
  return folders;
}

/// The figures that the pages of results show are those that `furnas figures` draws from the tables beside
/// them, byte for byte. The pictures (PNG) are not kept there.
TEST(StudyFigures, FollowFromTheTablesBesideThem) {
  const fs::path study = fs::path(FURNAS_SOURCE_DIR) / "docs/results/study";
  const TemporaryFolder folder;
  const fs::path drawn = folder / "figures";
  std::vector<std::string> command{"figures"};
  for (const std::string& tables : table_folders(study)) command.push_back(tables);
  command.insert(command.end(), {"--out", drawn.string()});
  const Ending drawing = ending_of(command);
  ASSERT_EQ(drawing.code, 0) << drawing.out;
  std::size_t kept = 0;
  for (const auto& file : fs::directory_iterator(study / "figures")) {
    EXPECT_EQ(content(file.path()), content(drawn / file.path().filename())) << file.path();
    ++kept;
  }
  const auto is_kept = [](const fs::directory_entry& file) { return file.path().extension() != ".png"; };
  EXPECT_EQ(std::count_if(fs::directory_iterator(drawn), fs::directory_iterator(), is_kept), kept);
}

}  // namespace
}  // namespace furnas
