#include "engine/analysis/pair_correlation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/base/require.h"
#include "engine/start/replicate.h"
#include "engine/trials/crystal.h"
#include "tests/engine/support/random_packing.h"
#include "tests/engine/support/setups.h"

namespace furnas {
namespace {

using test::Dice;

/// A bin width on whose multiples no shell of the crystals below lies.
constexpr double odd_bin = 0.0437;

struct Shell {
  double distance;  ///< [nearest neighbours]
  double count;
};

/// Partners appear at the shells, in their number, and nowhere else.
void expect_shells(const PairCorrelation& found, double unit, const std::vector<Shell>& shells) {
  std::vector<double> expected(found.g.size());
  for (const auto& [distance, count] : shells) {
    const auto bin = static_cast<std::size_t>(distance * unit / found.edges[1]);
    ASSERT_LT(bin, expected.size());
    expected[bin] += count;
  }
  double sum = 0;
  for (std::size_t b = 0; b < expected.size(); ++b) {
    sum += expected[b];
    EXPECT_DOUBLE_EQ(static_cast<double>(found.counts[b]), expected[b] * static_cast<double>(found.origins))
        << b;
    EXPECT_DOUBLE_EQ(found.neighbours[b], sum) << b;
    EXPECT_EQ(found.g[b] == 0, expected[b] == 0) << b;
  }
}

const std::vector<Shell> cubic_shells{
    {1, 6}, {std::sqrt(2), 12}, {std::sqrt(3), 8}, {2, 6}, {std::sqrt(5), 24}};
const std::vector<Shell> face_centred_shells{
    {1, 12}, {std::sqrt(2), 6}, {std::sqrt(3), 24}, {2, 12}, {std::sqrt(5), 24}};

TEST(PairCorrelation, OfCrystalsStandsInTheirShells) {
  constexpr double r = 0.9, reach = 2.2;
  const PairCorrelationOptions options{.reach = reach, .bin = odd_bin};
  for (const Packing& p : {simple_cubic(r, 6), reskewed(simple_cubic(r, 6), 1, 1, -1)}) {
    const auto found = pair_correlation(p, options);
    ASSERT_EQ(found.size(), 1U);
    expect_shells(found[0], r, cubic_shells);
  }
  for (const Packing& p : {face_centred(r, 4), reskewed(face_centred(r, 4), -1, 2, 1)})
    expect_shells(pair_correlation(p, options).at(0), r, face_centred_shells);
}

/// Integrated over the peak of a shell, the density times g is its number of partners.
TEST(PairCorrelation, IntegratesToTheCoordination) {
  constexpr double r = 0.9;
  const Packing p = face_centred(r, 4);
  const PairCorrelation found = pair_correlation(p, {.reach = 2.2, .bin = odd_bin}).at(0);
  const double density = static_cast<double>(p.size()) / p.cell.volume();
  double integral = 0;
  for (std::size_t b = 0; b < found.g.size() && found.edges[b + 1] < 1.2 * r; ++b)
    integral += density * found.g[b] * 4 * std::numbers::pi / 3 *
                (std::pow(found.edges[b + 1], 3) - std::pow(found.edges[b], 3));
  EXPECT_NEAR(integral, 12, 1e-12);
}

/// Large spheres at the corners of cubes, small ones in their middles (CsCl): eight of the others all around.
TEST(PairCorrelation, TellsKindsApart) {
  constexpr double a = 2;
  constexpr int cells = 4;
  std::vector<Ball> balls;
  for (int n = 0; n < cells * cells * cells; ++n) {
    const Vec3<double> corner{a * (n % cells), a * (n / cells % cells), a * (n / cells / cells)};
    balls.push_back({.position = corner, .radius = 0.7});
    balls.push_back({.position = corner + Vec3<double>{a / 2, a / 2, a / 2}, .radius = 0.5});
  }
  const auto found = pair_correlation(packing_of(cube(cells * a), balls), {.reach = 1.9 * a, .bin = odd_bin});
  ASSERT_EQ(found.size(), 4U);
  const std::vector<Shell> same{{1, 6}, {std::sqrt(2), 12}, {std::sqrt(3), 8}};
  const std::vector<Shell> other{{std::sqrt(0.75), 8}, {std::sqrt(2.75), 24}};
  std::vector<Shell> both = same;
  both.insert(both.end(), other.begin(), other.end());
  EXPECT_EQ(found[0].kind, PairKind::large_large);
  EXPECT_NEAR(found[0].contact, 1.4, 1e-13);
  expect_shells(found[0], a, same);
  EXPECT_EQ(found[1].kind, PairKind::large_small);
  EXPECT_NEAR(found[1].contact, 1.2, 1e-13);
  expect_shells(found[1], a, other);
  EXPECT_EQ(found[2].kind, PairKind::small_small);
  expect_shells(found[2], a, same);
  EXPECT_FALSE(found[3].kind);
  EXPECT_NEAR(found[3].contact, 1.2, 1e-13);
  double sum = 0;
  for (const auto& [distance, count] : both) sum += count;
  EXPECT_DOUBLE_EQ(found[3].neighbours.back(), sum);
}

/// Every image of every particle, one by one.
std::vector<std::int64_t> brute_counts(const Packing& p, Species from, Species to, double bin,
                                       std::size_t bins) {
  std::vector<std::int64_t> counts(bins);
  constexpr int far = 12;  // cells
  for (std::size_t i = 0; i < p.size(); ++i)
    for (std::size_t j = 0; j < p.size(); ++j) {
      if (p.species[i] != from || p.species[j] != to) continue;
      const Vec3<double> d = in_unit_cell(p.fraction[i]) - in_unit_cell(p.fraction[j]);
      for (int x = -far; x <= far; ++x)
        for (int y = -far; y <= far; ++y)
          for (int z = -far; z <= far; ++z) {
            if (i == j && x == 0 && y == 0 && z == 0) continue;
            const double r = norm(p.cell.edges * (d + Vec3<double>{double(x), double(y), double(z)}));
            if (const double b = std::floor(r / bin); b < static_cast<double>(bins))
              ++counts[static_cast<std::size_t>(b)];
          }
    }
  return counts;
}

TEST(PairCorrelation, CountsEveryImageInSkewedCellsOfAnySize) {
  Dice dice(5);
  for (int round = 0; round < 12; ++round) {
    const Packing p = test::random_packing(dice, {.large = 3, .small = 6, .size_ratio = 1.5, .cell = 3});
    const Vec3<double> h = heights(p.cell.edges);
    // Up to three cells far; beyond twelve of them the brute force would have to look.
    const double reach = dice.between(0.4, 3) * std::min({h.x, h.y, h.z});
    const auto found = pair_correlation(p, {.reach = reach, .bin = odd_bin});
    ASSERT_EQ(found.size(), 4U);
    const std::size_t bins = found[0].counts.size();
    const std::array<std::vector<std::int64_t>, 3> counts{
        brute_counts(p, Species::large, Species::large, odd_bin, bins),
        brute_counts(p, Species::large, Species::small, odd_bin, bins),
        brute_counts(p, Species::small, Species::small, odd_bin, bins)};
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_EQ(found[k].counts, counts[k]) << "round " << round << ", kind " << k;
    for (std::size_t b = 0; b < bins; ++b) {
      const auto ordered = static_cast<double>(counts[0][b] + 2 * counts[1][b] + counts[2][b]);
      const double shell =
          4 * std::numbers::pi / 3 * (std::pow(found[3].edges[b + 1], 3) - std::pow(found[3].edges[b], 3));
      EXPECT_NEAR(found[3].g[b], ordered / (9 * 9 / p.cell.volume() * shell), 1e-12 * found[3].g[b]) << b;
    }
  }
}

/// fcc in its smallest cells, where most neighbours are images of the particle itself.
TEST(PairCorrelation, CountsAParticlesOwnImages) {
  constexpr double r = 0.9;
  const PairCorrelationOptions options{.reach = 2.2, .bin = odd_bin};
  expect_shells(pair_correlation(face_centred(r, 1), options).at(0), r, face_centred_shells);
  expect_shells(pair_correlation(face_centred_primitive(r), options).at(0), r, face_centred_shells);
}

TEST(PairCorrelation, IsThatOfTheCellRepeated) {
  Dice dice(8);
  const Packing p = test::random_packing(dice, {.large = 3, .small = 6, .size_ratio = 1.5, .cell = 3});
  const PairCorrelationOptions options{.reach = 4, .bin = odd_bin};
  const auto once = pair_correlation(p, options), twice = pair_correlation(replicate(p, {2, 1, 3}), options);
  ASSERT_EQ(once.size(), twice.size());
  for (std::size_t n = 0; n < once.size(); ++n)
    for (std::size_t b = 0; b < once[n].g.size(); ++b)
      EXPECT_NEAR(once[n].g[b], twice[n].g[b], 1e-12 * once[n].g[b]) << n << ' ' << b;
}

/// A gas in which no one knows of anyone: 1 at all distances short of a particle's own images, with the
/// errors told.
void expect_ideal(const std::vector<PairCorrelation>& all) {
  ASSERT_EQ(all.size(), 4U);
  for (const PairCorrelation& found : all) {
    double chi_squared = 0, bins = 0, weighted = 0, weights = 0;
    for (std::size_t b = 0; b < found.g.size(); ++b) {
      if (found.counts[b] < 25) continue;  // too few for a normal deviate
      const double deviation = (found.g[b] - 1) / found.error[b];
      chi_squared += deviation * deviation;
      weighted += found.g[b] / (found.error[b] * found.error[b]);
      weights += 1 / (found.error[b] * found.error[b]);
      ++bins;
    }
    EXPECT_GT(bins, 30);
    EXPECT_NEAR(chi_squared, bins, 4 * std::sqrt(2 * bins)) << bool(found.kind);
    // Bins of few counts weigh more when they fall low: a bias of one count in all, over the smallest 25.
    EXPECT_NEAR(weighted / weights, 1, 4 / std::sqrt(weights) + 1 / 25.0 / bins) << bool(found.kind);
  }
}

TEST(PairCorrelation, OfAnIdealGasIsOneWithinItsError) {
  Dice dice(6);
  const Packing p = [&] {
    Packing gas = test::random_packing(dice, {.large = 600, .small = 1200, .size_ratio = 1.3, .cell = 12});
    for (Fraction& s : gas.fraction) s = {dice.word(), dice.word(), dice.word()};
    return gas;
  }();
  expect_ideal(pair_correlation(p, {.reach = 9, .bin = 0.1}));
  // Looked at from every so many particles only.
  const auto sampled = pair_correlation(p, {.reach = 9, .bin = 0.1, .most_pairs = 2e5});
  EXPECT_LT(sampled[0].origins, 300);
  EXPECT_LT(sampled[2].origins, 300);
  expect_ideal(sampled);
}

TEST(PairCorrelation, TakesWiderBinsForWiderPairs) {
  Dice dice(7);
  const Packing p = test::random_packing(dice, {.large = 4, .small = 20, .size_ratio = 5.2, .cell = 12});
  const auto found = pair_correlation(p, {.reach = 6, .bin = 0.02});
  ASSERT_EQ(found.size(), 4U);
  EXPECT_DOUBLE_EQ(found[0].edges[1], 5 * 0.02);
  EXPECT_DOUBLE_EQ(found[1].edges[1], 3 * 0.02);
  EXPECT_DOUBLE_EQ(found[2].edges[1], 0.02);
  EXPECT_DOUBLE_EQ(found[3].edges[1], 0.02);
}

TEST(PairCorrelation, ChoosesItsReach) {
  EXPECT_DOUBLE_EQ(chosen_reach(simple_cubic(0.9, 4)), 2.5);
  EXPECT_DOUBLE_EQ(chosen_reach(simple_cubic(0.9, 8)), 3.6);
  EXPECT_DOUBLE_EQ(chosen_reach(simple_cubic(0.9, 20)), 5);
  EXPECT_NEAR(pair_correlation(simple_cubic(0.9, 8)).at(0).edges.back(), 3.6, 0.02);
}

TEST(PairCorrelation, RefusesWhatCannotBeCounted) {
  const Packing p = simple_cubic(0.9, 4);
  EXPECT_THROW(pair_correlation(p, {.reach = 40}), InputError);
  EXPECT_THROW(pair_correlation(p, {.reach = 2, .bin = 3}), InputError);
  EXPECT_THROW(pair_correlation(p, {.reach = 2, .bin = 1e-9}), InputError);
  EXPECT_TRUE(pair_correlation(Packing{}).empty());
}

}  // namespace
}  // namespace furnas
