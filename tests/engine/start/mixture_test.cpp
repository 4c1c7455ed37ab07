#include "engine/start/mixture.h"

#include <gtest/gtest.h>

#include "engine/base/require.h"
#include "tests/engine/support/same_packing.h"

namespace furnas {
namespace {

const Mixture mixtures[] = {
    {.size_ratio = 1, .small_fraction = 0, .large = 1000},
    {.size_ratio = 1, .small_fraction = 0, .large = 1, .start_fraction = 0.5},
    {.size_ratio = 1, .small_fraction = 0, .large = 400, .start_fraction = 0.3},
    {.size_ratio = 5, .small_fraction = 0.25, .large = 30, .start_fraction = 0.2},
    {.size_ratio = 40, .small_fraction = 0.03, .large = 1},
    {.size_ratio = 40, .small_fraction = 0.02, .large = 1, .start_fraction = 0.4},
};

class DiluteStart : public ::testing::TestWithParam<Mixture> {};

TEST_P(DiluteStart, HasTheMixtureAskedFor) {
  const Mixture& m = GetParam();
  const Packing p = dilute_start(m);
  const double a3 = std::pow(m.size_ratio, 3);
  const auto large = static_cast<double>(m.large);
  const double small = large * a3 * m.small_fraction / (1 - m.small_fraction);
  EXPECT_LE(std::abs(static_cast<double>(small_count(m)) - small), 0.5);
  ASSERT_EQ(p.size(), static_cast<std::size_t>(m.large + small_count(m)));
  EXPECT_NEAR(p.fraction_filled(), m.start_fraction, 1e-13);
  const double share =
      static_cast<double>(small_count(m)) / (large * a3 + static_cast<double>(small_count(m)));
  EXPECT_NEAR(share, m.small_fraction, 0.5 / (large * a3));
  for (std::size_t k = 0; k < p.size(); ++k) {
    const bool is_large = k < static_cast<std::size_t>(m.large);
    EXPECT_EQ(p.species[k], is_large ? Species::large : Species::small);
    EXPECT_EQ(p.radius[k], is_large ? m.size_ratio / 2 : 0.5);
    EXPECT_NEAR(p.mass[k], std::numbers::pi / 6 * std::pow(2 * p.radius[k], 3), 1e-12 * p.mass[k]);
    EXPECT_EQ(p.velocity[k], Vec3<double>{});
    EXPECT_EQ(p.spin[k], Vec3<double>{});
    EXPECT_EQ(p.image[k], Image{});
  }
  const Triangle& h = p.cell.edges;
  EXPECT_EQ(h, (Triangle{h.xx, h.xx, h.xx, 0, 0, 0}));
  EXPECT_EQ(p.cell.rate, Triangle{});
}

TEST_P(DiluteStart, NoTwoSpheresTouch) {
  const Packing p = dilute_start(GetParam());
  const double length = p.cell.edges.xx;
  std::size_t touches = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    EXPECT_LT(2 * p.radius[i], length);  // so nearest images decide
    for (std::size_t j = 0; j < i; ++j) {
      const Vec3<double> d = length * nearest_difference(p.fraction[i], p.fraction[j]);
      const double reach = p.radius[i] + p.radius[j];
      touches += dot(d, d) < reach * reach;
    }
  }
  EXPECT_EQ(touches, 0u);
}

TEST_P(DiluteStart, TheSeedDecidesAllOfIt) {
  Mixture m = GetParam();
  const Packing p = dilute_start(m);
  EXPECT_TRUE(test::same_packing(dilute_start(m), p));
  m.seed = 2;
  EXPECT_FALSE(dilute_start(m).fraction == p.fraction);
}

INSTANTIATE_TEST_SUITE_P(Mixtures, DiluteStart, ::testing::ValuesIn(mixtures));

TEST(SmallCount, IsTheShareOfTheVolume) {
  EXPECT_EQ(small_count({.size_ratio = 1, .small_fraction = 0, .large = 7}), 0);
  EXPECT_EQ(small_count({.size_ratio = 2, .small_fraction = 0.5, .large = 10}), 80);
  EXPECT_EQ(small_count({.size_ratio = 10, .small_fraction = 0.2, .large = 4}), 1000);
  EXPECT_EQ(small_count({.size_ratio = 40, .small_fraction = 0.29, .large = 1000}), 26140845);
}

/// Chi-square of counts that should all be alike.
double chi_square(const std::vector<int>& counts, double expected) {
  double sum = 0;
  for (int n : counts) sum += (n - expected) * (n - expected) / expected;
  return sum;
}

// 8000 places in 64 boxes and along each axis: 63 degrees of freedom, so 63 +- 11.
TEST(DiluteStartPlaces, AreUniform) {
  const Packing p =
      dilute_start({.size_ratio = 1, .small_fraction = 0, .large = 8000, .start_fraction = 0.001});
  const double expected = 8000 / 64.0;
  std::vector<int> boxes(64), x(64), y(64), z(64);
  for (const Fraction& s : p.fraction) {
    ++boxes[(s.x >> 62) << 4 | (s.y >> 62) << 2 | s.z >> 62];
    ++x[s.x >> 58], ++y[s.y >> 58], ++z[s.z >> 58];
  }
  for (const auto& counts : {boxes, x, y, z}) {
    EXPECT_LT(chi_square(counts, expected), 63 + 5 * 11.2);
    EXPECT_GT(chi_square(counts, expected), 63 - 4 * 11.2);
  }
}

TEST(DiluteStartLimits, RefusesWhatHasNoPlace) {
  const auto start = [](double ratio, double share, std::int64_t large, double fraction) {
    dilute_start({.size_ratio = ratio, .small_fraction = share, .large = large, .start_fraction = fraction});
  };
  EXPECT_THROW(start(1, 0, 100, 0.7), InputError);
  EXPECT_THROW(start(1, 0, 1000, 0.999), InputError);
  EXPECT_THROW(start(3, 0.5, 20, 0.8), InputError);
  EXPECT_THROW(start(1, 0, 1, 0.6), InputError) << "a sphere that touches its own image";
  EXPECT_THROW(start(40, 0.02, 1, 0.7), InputError) << "a large sphere that touches its own image";
}

TEST(DiluteStart, RefusesWhatIsNoMixture) {
  EXPECT_THROW(dilute_start({.large = 0}), InputError);
  EXPECT_THROW(dilute_start({.large = -1}), InputError);
  for (const double ratio : {0.5, -2.0, std::nan(""), HUGE_VAL})
    EXPECT_THROW(dilute_start({.size_ratio = ratio, .small_fraction = 0.1, .large = 10}), InputError)
        << ratio;
  for (const double share : {-0.1, 1.0, 1.5, std::nan("")})
    EXPECT_THROW(dilute_start({.size_ratio = 2, .small_fraction = share, .large = 10}), InputError) << share;
}

}  // namespace
}  // namespace furnas
