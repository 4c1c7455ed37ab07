#include "cases/program/sweep/finite_size.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/cases/sweep/made_rows.h"

namespace furnas {
namespace {

Point equal_point(double friction, std::int64_t spheres, double pressure = 1e-4) {
  SampleTable table = paper_table();
  table.rows = {jammed_row("1.0", "0.0", std::to_string(friction), 1, 0.6)};
  table.rows[0].large = spheres;
  table.rows[0].friction = friction;
  table.rows[0].pressure = pressure;
  return points_of(table).front();
}

TEST(FiniteSize, IsToldWhereItHasBeenMeasured) {
  ASSERT_TRUE(size_shift(equal_point(0, 1000)));
  EXPECT_NEAR(size_shift(equal_point(0, 1000))->value, 0.0025, 1e-4);
  EXPECT_EQ(size_shift(equal_point(0, 4000))->value, size_shift(equal_point(0, 1000))->value / 2);
  EXPECT_EQ(finite_size_text(equal_point(0.3, 1000)), "+0.0000 +- 0.0020");
}

TEST(FiniteSize, IsUnknownElsewhere) {
  for (const Point& point : {equal_point(0, 100), equal_point(0.1, 1000), equal_point(0, 1000, 1e-2),
                             equal_point(0, 1000, std::nan(""))})
    EXPECT_EQ(finite_size_text(point), "unknown") << point.friction << " " << point.large;
  SampleTable table = paper_table();
  table.rows = {jammed_row("5.0", "0.3", "0.3", 1, 0.7)};
  table.rows[0].pressure = 1e-4;
  EXPECT_EQ(finite_size_text(points_of(table).front()), "unknown") << "mixtures";
  table.rows = {spent_row("5.0", "0.3", "0.3", 1)};
  EXPECT_EQ(finite_size_text(points_of(table).front()), "") << "there is no phi_J";
}

}  // namespace
}  // namespace furnas
