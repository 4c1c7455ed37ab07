#include "cases/program/output_page.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "cases/program/sweep/points.h"
#include "io/csv.h"
#include "io/result.h"
#include "tests/cases/sweep/made_rows.h"
#include "tests/io/packings.h"

namespace furnas {
namespace {

/// The names in the first column of a section's table.
std::vector<std::string> names_in_section(const std::string& page, const std::string& section) {
  const std::size_t begin = page.find("\n## " + section + "\n");
  std::vector<std::string> names;
  if (begin == page.npos) return names;
  std::istringstream lines(page.substr(begin + 1, page.find("\n## ", begin + 1) - begin));
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("| `")) names.push_back(line.substr(3, line.find('`', 3) - 3));
  return names;
}

std::vector<std::string> header_of(const std::string& table, std::size_t keys) {
  std::istringstream text(table);
  std::vector<std::string> names;
  read_csv_row(text, names, "table");
  names.erase(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(keys));
  return names;
}

/// They warn of thin cells at the limit that the program has.
TEST(OutputPage, NamesTheLimitOfThinCells) {
  const std::string page = output_page();
  const std::string limit = fmt::format("below {} the", least_thickness);
  std::size_t times = 0;
  for (std::size_t at = page.find(limit); at != page.npos; at = page.find(limit, at + 1)) ++times;
  EXPECT_EQ(times, 3u) << "result.json, sweep.csv and points.csv";
}

TEST(OutputPage, HasTheColumnsOfSweeps) {
  SampleTable table = paper_table();
  table.rows = {jammed_row("5.0", "0.3", "0.1", 7, 0.7)};
  EXPECT_EQ(names_in_section(output_page(), "sweep.csv"), header_of(csv(table), 3));
  EXPECT_EQ(names_in_section(output_page(), "points.csv"), header_of(csv(points_of(table), table.keys), 3));
}

TEST(OutputPage, IsThatOfTheDocs) {
  const std::filesystem::path file = std::filesystem::path(FURNAS_SOURCE_DIR) / "docs/reference/outputs.md";
  EXPECT_EQ(content(file), output_page()) << "furnas schema --outputs > docs/reference/outputs.md";
}

TEST(OutputPage, TellsWhatOfEachNumber) {
  std::istringstream lines(output_page());
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("| `")) continue;
    EXPECT_EQ(line.find("|  |", line.find('|', 4) + 2), line.npos)
        << "neither of what nor meaning is empty: " << line;
  }
}

}  // namespace
}  // namespace furnas
