#include "engine/analysis/histogram.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/base/require.h"
#include "tests/engine/support/dice.h"

namespace furnas {
namespace {

using test::Dice;

double integral(const Histogram& h) {
  double sum = 0;
  for (std::size_t b = 0; b < h.bins(); ++b) sum += h.density(b) * h.width(b);
  return sum;
}

TEST(Histogram, EachEdgeBelongsToTheBinAboveTheLastToTheBinBelow) {
  const Histogram h = histogram({-1e-9, 0, 0.5, 1, 1.5, 3, 3, 3.0000001, NAN}, {0, 1, 3});
  EXPECT_EQ(h.counts, (std::vector<std::int64_t>{2, 4}));
  EXPECT_EQ(h.below, 2) << "what is no number is in no bin";
  EXPECT_EQ(h.above, 1);
  EXPECT_EQ(h.values(), 9);
  EXPECT_DOUBLE_EQ(h.density(0), 2.0 / 9);
  EXPECT_DOUBLE_EQ(h.density(1), 4.0 / 9 / 2);
}

TEST(Histogram, EdgesHoldAllThatTheyAreLaidFor) {
  EXPECT_EQ(linear_edges(0.5, 1), (std::vector<double>{0, 0.5, 1}));
  EXPECT_EQ(linear_edges(0.5, 1.01), (std::vector<double>{0, 0.5, 1, 1.5}));
  EXPECT_EQ(linear_edges(0.5, 0), (std::vector<double>{0, 0.5}));
  const std::vector<double> decades = logarithmic_edges(1, 0.02, 20);
  ASSERT_EQ(decades.size(), 5U);
  for (std::size_t n = 0; n < 5; ++n) EXPECT_DOUBLE_EQ(decades[n], 0.01 * std::pow(10.0, n));
  Dice dice(1);
  for (int round = 0; round < 1000; ++round) {
    const double least = std::pow(10.0, dice.between(-9, 3)),
                 most = least * std::pow(10.0, dice.between(0, 4));
    const auto per_decade = static_cast<int>(1 + dice.below(20));
    const std::vector<double> edges = logarithmic_edges(per_decade, least, most);
    EXPECT_LE(edges.front(), least);
    EXPECT_GE(edges.back(), most);
    const double width = dice.between(0.01, 1);
    EXPECT_GE(linear_edges(width, most / least).back(), most / least);
  }
}

TEST(Histogram, DensityIntegratesToOne) {
  Dice dice(2);
  std::vector<double> values;
  for (int n = 0; n < 1000; ++n) values.push_back(-std::log(dice.between(1e-9, 1)));
  EXPECT_NEAR(integral(histogram(values, linear_edges(0.3, 25))), 1, 1e-12);
  EXPECT_NEAR(integral(histogram(values, logarithmic_edges(7, 1e-12, 25))), 1, 1e-12);
}

/// Bins of any shape estimate the same density: exp(-x), here.
TEST(Histogram, DensityIsThatOfTheDistributionTheValuesAreDrawnFrom) {
  Dice dice(3);
  std::vector<double> values;
  for (int n = 0; n < 100'000; ++n) values.push_back(-std::log(dice.between(0, 1)));
  for (const auto& edges : {linear_edges(0.2, 4), logarithmic_edges(10, 0.01, 4)}) {
    const Histogram h = histogram(values, edges);
    double chi_squared = 0;
    for (std::size_t b = 0; b < h.bins(); ++b) {
      const double expected = 1e5 * (std::exp(-h.edges[b]) - std::exp(-h.edges[b + 1]));
      const double excess = h.density(b) * h.width(b) * 1e5 - expected;
      chi_squared += excess * excess / expected;
    }
    const auto bins = static_cast<double>(h.bins());
    // The sum of n squares of normal deviates is n with the spread sqrt(2 n).
    EXPECT_NEAR(chi_squared, bins, 4 * std::sqrt(2 * bins));
  }
}

TEST(Histogram, RefusesEdgesThatAreNone) {
  EXPECT_THROW(histogram({1}, {0}), ContractError);
  EXPECT_THROW(histogram({1}, {1, 0}), ContractError);
  EXPECT_THROW(logarithmic_edges(10, 0, 1), ContractError);
  EXPECT_THROW(linear_edges(0, 1), ContractError);
}

}  // namespace
}  // namespace furnas
