#include <gtest/gtest.h>

#include <cctype>
#include <filesystem>
#include <regex>
#include <set>
#include <sstream>
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
                            content(tree / "tests/library/CMakeLists.txt") +
                            content(tree / "tests/CMakeLists.txt");
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

/// What GitHub and the site make of the headings of a page, to be linked to.
std::set<std::string> anchors(const fs::path& page) {
  std::set<std::string> all;
  std::istringstream text(content(page));
  bool fenced = false;
  for (std::string line; std::getline(text, line);) {
    if (line.starts_with("```")) fenced = !fenced;
    if (fenced || !line.starts_with("#")) continue;
    std::string anchor;
    for (const unsigned char letter : line.substr(line.find(' ') + 1))
      if (std::isalnum(letter) != 0 || letter == '_' || letter == '-')
        anchor += static_cast<char>(std::tolower(letter));
      else if (letter == ' ')
        anchor += '-';
    all.insert(anchor);
  }
  return all;
}

/// Each relative link and picture of a page leads to a file of the tree, and to a heading of it.
TEST(Documents, LinkToPlacesThatExist) {
  std::vector<fs::path> pages = {"README.md", "CONTRIBUTING.md", "CHANGELOG.md"};
  for (const auto& entry : fs::recursive_directory_iterator(tree / "docs"))
    if (entry.path().extension() == ".md") pages.push_back(fs::relative(entry.path(), tree));
  int found = 0;
  for (const fs::path& page : pages)
    each_match(content(tree / page), std::regex(R"(\]\(([^)#\s]*)(?:#([^)\s]*))?\))"),
               [&](const std::smatch& match) {
                 if (match[1].str().find("://") != std::string::npos) return;
                 const fs::path target =
                     match[1].length() > 0 ? tree / page.parent_path() / match[1].str() : tree / page;
                 EXPECT_TRUE(fs::exists(target)) << page << ": " << match[0];
                 EXPECT_TRUE(match[2].length() == 0 || anchors(target).contains(match[2]))
                     << page << ": " << match[0];
                 ++found;
               });
  EXPECT_GT(found, 100);
}

}  // namespace
}  // namespace furnas
