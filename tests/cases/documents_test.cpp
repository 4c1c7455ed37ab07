#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <string>
#include <vector>

#include "tests/io/packings.h"

namespace furnas {
namespace {

namespace fs = std::filesystem;

const fs::path tree = FURNAS_SOURCE_DIR;

/// What all files of a folder with this extension say.
std::string all_of(const fs::path& folder, const std::string& extension) {
  std::string text;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.path().extension() == extension) text += content(entry.path());
  return text;
}

/// Calls visit(match) for each place where the pattern is found.
template <class Visit>
void each_match(const std::string& text, const std::regex& pattern, Visit&& visit) {
  for (std::sregex_iterator at(text.begin(), text.end(), pattern), end; at != end; ++at) visit(*at);
}

std::string documents() { return all_of(tree / "docs", ".md") + content(tree / "README.md"); }

TEST(Documents, NameTestsThatExist) {
  const std::string tests = all_of(tree / "tests", ".cpp") + content(tree / "cmake/kernels.cmake") +
                            content(tree / "tests/library/CMakeLists.txt");
  int found = 0;
  each_match(documents(), std::regex(R"(`([A-Z]\w*)\.([A-Z*]\w*)`)"), [&](const std::smatch& match) {
    const std::string suite = match[1], test = match[2];
    const std::string one = suite + ", " + test + ")", in_cmake = suite + "." + test;
    const bool exists = test == "*" ? tests.find("(" + suite + ", ") != tests.npos
                                    : tests.find(one) != tests.npos || tests.find(in_cmake) != tests.npos;
    EXPECT_TRUE(exists) << match[0];
    ++found;
  });
  EXPECT_GT(found, 10);
}

TEST(Documents, AreWhereTheyAreSaidToBe) {
  std::string text = documents();
  for (const char* room : {"engine", "io", "viz", "cases", "tests"})
    for (const char* extension : {".h", ".cpp", ".toml"}) text += all_of(tree / room, extension);
  int found = 0;
  each_match(text, std::regex(R"(\bdocs/([\w/-]+\.(md|sh|svg|png|cpp|csv)))"), [&](const std::smatch& match) {
    EXPECT_TRUE(fs::exists(tree / match[0].str())) << match[0];
    ++found;
  });
  EXPECT_GT(found, 10);
}

/// Each relative link and picture of a page leads to a file of the tree.
TEST(Documents, LinkToFilesThatExist) {
  std::vector<fs::path> pages = {"README.md", "CONTRIBUTING.md", "CHANGELOG.md"};
  for (const auto& entry : fs::recursive_directory_iterator(tree / "docs"))
    if (entry.path().extension() == ".md") pages.push_back(fs::relative(entry.path(), tree));
  int found = 0;
  for (const fs::path& page : pages)
    each_match(content(tree / page), std::regex(R"(\]\(([^)#\s]+)[^)]*\))"), [&](const std::smatch& match) {
      const std::string target = match[1];
      if (target.find("://") != target.npos) return;
      EXPECT_TRUE(fs::exists(tree / page.parent_path() / target)) << page << ": " << match[0];
      ++found;
    });
  EXPECT_GT(found, 50);
}

}  // namespace
}  // namespace furnas
