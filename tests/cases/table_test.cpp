#include "cases/program/table.h"

#include <gtest/gtest.h>

#include "engine/base/require.h"

namespace furnas {
namespace {

TEST(Table, StandsInColumnsAndReadsAsCsv) {
  Table table({"name", "N"});
  table.row({"a", "1000000"});
  table.row({"longer", "2"});
  EXPECT_EQ(table.aligned(), "  name        N\n     a  1000000\nlonger        2\n");
  EXPECT_EQ(table.csv(), "name,N\na,1000000\nlonger,2\n");
  EXPECT_THROW(table.row({"one cell"}), ContractError);
  table.row({"a,b", "1"});
  EXPECT_EQ(table.csv(), "name,N\na,1000000\nlonger,2\n\"a,b\",1\n");
  EXPECT_EQ(Table({"x, y"}).csv(), "\"x, y\"\n");
}

TEST(Spread, HasTheMiddleAndTheEnds) {
  const Spread odd = spread_of({3, 1, 10});
  EXPECT_EQ(odd.median, 3);
  EXPECT_EQ(odd.low, 1);
  EXPECT_EQ(odd.high, 10);
  EXPECT_EQ(spread_of({4, 2}).median, 3);
  EXPECT_EQ(text_of(odd), "3 (1 - 10)");
  EXPECT_THROW(spread_of({}), ContractError);
}

}  // namespace
}  // namespace furnas
