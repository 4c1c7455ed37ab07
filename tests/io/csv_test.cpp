#include "io/csv.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "engine/base/require.h"

namespace furnas {
namespace {

using Cells = std::vector<std::string>;

std::vector<Cells> parsed(const std::string& text) {
  std::istringstream file(text);
  std::vector<Cells> rows;
  for (Cells cells; read_csv_row(file, cells, "a.csv");) rows.push_back(cells);
  return rows;
}

TEST(Csv, QuotesWhatNeedsIt) {
  EXPECT_EQ(csv_row({"a", "", "1.5"}), "a,,1.5\n");
  EXPECT_EQ(csv_row({"a,b", "say \"no\"", "two\nlines", "two words"}),
            "\"a,b\",\"say \"\"no\"\"\",\"two\nlines\",two words\n");
  EXPECT_EQ(csv_row({""}), "\n");
}

TEST(Csv, ReadsWhatItWrites) {
  const std::vector<Cells> rows{{"a,b", "\"", "\"\"", ",", ""},
                                {"two\nlines", "x", "\"a\",\"b\"", " ", "\n"}};
  EXPECT_EQ(parsed(csv_row(rows[0]) + csv_row(rows[1])), rows);
}

TEST(Csv, ReadsWhatOthersWrite) {
  EXPECT_EQ(parsed("a,\"b,c\"\r\n\"d\",e"), (std::vector<Cells>{{"a", "b,c"}, {"d", "e"}}));
  EXPECT_EQ(parsed("\n,\n"), (std::vector<Cells>{{""}, {"", ""}}));
  EXPECT_TRUE(parsed("").empty());
}

// furnas 0.2.0 quoted a cell for its comma, not for its quotes.
TEST(Csv, TakesLooseQuotesAsTheyStand) {
  EXPECT_EQ(parsed("\"x\" is no law; allowed: y,1\n"),
            (std::vector<Cells>{{"\"x\" is no law; allowed: y", "1"}}));
  EXPECT_EQ(parsed("the law \"x\",1\n"), (std::vector<Cells>{{"the law \"x\"", "1"}}));
}

TEST(Csv, RefusesQuotesThatAreNeverClosed) {
  EXPECT_EQ(parsed("\"a\nb\",c\n").size(), 1u);
  EXPECT_THROW(parsed("\"a\nb,c\n"), InputError);
  std::string table = "\"a\n";
  for (int row = 0; row < 100'000; ++row) table += "0.123456789,0.123456789\n";
  std::istringstream file(table);
  Cells cells;
  EXPECT_THROW(read_csv_row(file, cells, "a.csv"), InputError);
  EXPECT_LT(file.tellg(), 1'100'000) << "of 2.4 MB";
}

TEST(Csv, NamesWhatCannotBeRead) {
  std::ifstream folder("/");  // can be opened as a file, but not read
  Cells cells;
  EXPECT_THROW(read_csv_row(folder, cells, "a.csv"), InputError);
}

TEST(WithoutCommas, NeedsNoQuotes) {
  EXPECT_EQ(without_commas("spent, it waits\nfor rest"), "spent; it waits for rest");
}

}  // namespace
}  // namespace furnas
