#include "engine/base/numbers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <sstream>

namespace furnas {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(NumberIn, TakesTheWholeWordOrNothing) {
  EXPECT_EQ(number_in<double>("1.5e-05"), 1.5e-5);
  EXPECT_EQ(number_in<double>("-inf"), -infinity);
  EXPECT_TRUE(std::isnan(number_in<double>("nan").value()));
  EXPECT_EQ(number_in<std::int64_t>("-9223372036854775808"), std::numeric_limits<std::int64_t>::min());
  for (const char* word : {"", " 1", "1 ", "1.5x", "1,5", "+1", "1e999", "one"})
    EXPECT_FALSE(number_in<double>(word)) << word;
  for (const char* word : {"", "1.0", "9223372036854775808", "0x10"})
    EXPECT_FALSE(number_in<std::int64_t>(word)) << word;
  EXPECT_FALSE(number_in<std::uint64_t>("-1"));
}

TEST(Numbers, TakesThemInTurn) {
  std::int64_t count = 0;
  double x = 0;
  bool yes = false, no = true;
  EXPECT_TRUE(Numbers(" 3\t0.1 1\n0").take_all(count, x, yes, no));
  EXPECT_EQ(count, 3);
  EXPECT_EQ(x, 0.1);
  EXPECT_TRUE(yes);
  EXPECT_FALSE(no);
}

TEST(Numbers, RefusesWhatIsMissingLeftOverOrNoNumber) {
  std::int64_t count = 0;
  double x = 0;
  bool flag = false;
  EXPECT_FALSE(Numbers("3").take_all(count, x));
  EXPECT_FALSE(Numbers("3 0.1 4").take_all(count, x));
  EXPECT_FALSE(Numbers("3 0.1 ").take_all(count, x));
  EXPECT_FALSE(Numbers("3 0.1x").take_all(count, x));
  EXPECT_FALSE(Numbers("3.5 0.1").take_all(count, x));
  EXPECT_FALSE(Numbers("2").take_all(flag));
  EXPECT_FALSE(Numbers("").take(x));
}

TEST(Numbers, GoesThroughRows) {
  Numbers rows("1 0.5\n2 0.25\n");
  double sum = 0;
  int count = 0;
  while (rows.more()) {
    std::int64_t number = 0;
    double value = 0;
    ASSERT_TRUE(rows.take(number, value));
    EXPECT_EQ(number, ++count);
    sum += value;
  }
  EXPECT_EQ(sum, 0.75);
}

TEST(ExactText, ReadsBackToTheLastBit) {
  for (const double x :
       {0.1, -1.0 / 3, 1e-310, std::nextafter(1.0, 2.0), 1.7976931348623157e308, -0.0, infinity}) {
    double read = 1;
    ASSERT_TRUE(Numbers(exact_text(x)).take_all(read)) << x;
    EXPECT_EQ(read, x);
    EXPECT_EQ(std::signbit(read), std::signbit(x));
  }
  EXPECT_EQ(exact_text(2, 0.5, std::int64_t{1}, 3, 1.5e-5), "2 0.5 1 3 1.5e-05");
}

// Checkpoints of furnas 0.2.0 hold what a stream wrote with 17 digits; the same bytes come out.
TEST(ExactText, IsThatOfAStream) {
  for (const double x : {0.1, 1.5e-5, 1.0, 123456789.0, 1e17, 1e-310, -2.0 / 3, infinity}) {
    std::ostringstream stream;
    stream.precision(17);
    stream << x;
    EXPECT_EQ(exact_text(x), stream.str());
  }
}

}  // namespace
}  // namespace furnas
