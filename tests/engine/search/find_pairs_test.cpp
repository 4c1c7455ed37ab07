#include "engine/search/find_pairs.h"

#include <gtest/gtest.h>

#include "engine/base/require.h"
#include "engine/search/carry_over.h"
#include "engine/trials/listed.h"
#include "tests/engine/support/brute_force.h"
#include "tests/engine/support/property.h"
#include "tests/engine/support/random_packing.h"

namespace furnas {
namespace {

using test::Dice;
using test::TouchName;

struct Case {
  Packing packing;
  Skin skin;
};

Case random_case() {
  Dice dice(test::any_seed());
  test::RandomPacking wanted;
  wanted.size_ratio = *rc::gen::element(1, 2, 7, 40);
  wanted.large = *rc::gen::inRange<std::size_t>(0, 4);
  wanted.small = *rc::gen::inRange<std::size_t>(1, 60);
  wanted.cell = (wanted.large > 0 ? wanted.size_ratio : 1) * dice.between(0.5, 6);
  wanted.spread = dice.chance(0.5) ? 0 : 0.6;
  return {in_memory_order(test::random_packing(dice, wanted)),
          {dice.chance(0.2) ? 0 : dice.between(0, 0.6), dice.chance(0.5) ? 0 : dice.between(0, 0.2)}};
}

/// The pair and image of each row, in the words of the brute force.
std::map<TouchName, std::uint64_t> rows_by_name(const Packing& p, const PairList& list) {
  std::map<TouchName, std::uint64_t> rows;
  for (std::uint32_t i = 0; i < p.size(); ++i)
    for (std::uint64_t k = list.first[i]; k < list.first[i + 1]; ++k) {
      Contact c;
      c.i = i;
      c.j = list.partner[k];
      c.image = image_of_row(list, k, p.fraction[i], p.fraction[c.j]);
      RC_ASSERT(rows.emplace(test::name_of(p, c), k).second);
    }
  return rows;
}

// Whatever the former list and its grids held, nothing of it remains.
TEST(FindPairs, InTheMemoryOfAFormerListGivesTheSameList) {
  EXPECT_TRUE(test::holds(500, [] {
    const auto [then, former_skin] = random_case();
    const auto [now, skin] = random_case();
    PairList list = listed(then, former_skin);
    std::vector<Grid> grids = bin_classes(list.classes, former_skin, then.cell.edges, then.fraction);
    list.classes = size_classes(now.radius);
    list.skin = skin;
    list.reference = now.fraction;
    grids = bin_classes(list.classes, skin, now.cell.edges, now.fraction, std::move(grids));
    find_pairs(grids, now.cell.edges, now.radius, list);
    const PairList fresh = listed(now, skin);
    RC_ASSERT(list.first == fresh.first && list.partner == fresh.partner && list.quarter == fresh.quarter);
    RC_ASSERT(list.incoming_first == fresh.incoming_first && list.incoming == fresh.incoming);
    RC_ASSERT(list.edges == fresh.edges);
  }));
}

TEST(FindPairs, ListsExactlyThePairsWithinTheSkin) {
  EXPECT_TRUE(test::holds(2000, [] {
    const auto [p, skin] = random_case();
    const PairList list = listed(p, skin);
    const auto rows = rows_by_name(p, list);
    double largest = 0;
    for (double r : p.radius) largest = std::max(largest, r);
    const auto pairs = test::brute_pairs(p, 1.01 * skin(2 * largest) + 1e-6);
    for (const auto& [name, row] : rows) RC_ASSERT(pairs.contains(name));
    for (const auto& [name, pair] : pairs) {
      const double radii = p.radius[name.i] + p.radius[name.j];
      const double excess = static_cast<double>(pair.distance) / (radii + skin(radii)) - 1;
      if (std::abs(excess) < 2e-9) continue;  // either way is right
      RC_ASSERT(rows.contains(name) == (excess < 0));
    }
    RC_ASSERT(list.edges == p.cell.edges);
    RC_ASSERT(list.reference == p.fraction);
  }));
}

TEST(FindPairs, RowsAreInTheOrderOfMemory) {
  EXPECT_TRUE(test::holds(500, [] {
    const auto [p, skin] = random_case();
    const PairList list = listed(p, skin);
    RC_ASSERT(list.first.size() == p.size() + 1);
    RC_ASSERT(list.first.front() == 0u);
    RC_ASSERT(list.first.back() == list.rows());
    RC_ASSERT(list.quarter.empty() || list.quarter.size() == list.rows());
    for (std::uint32_t i = 0; i < p.size(); ++i)
      for (std::uint64_t k = list.first[i]; k < list.first[i + 1]; ++k) {
        RC_ASSERT(list.partner[k] <= i);
        if (k == list.first[i]) continue;
        RC_ASSERT(list.partner[k - 1] <= list.partner[k]);
        // Images of one pair differ by whole cells; they ascend.
        if (list.partner[k - 1] == list.partner[k]) RC_ASSERT(list.quarter[k - 1] < list.quarter[k]);
      }
  }));
}

TEST(FindPairs, IncomingRowsAreThoseOfThePartner) {
  EXPECT_TRUE(test::holds(500, [] {
    const auto [p, skin] = random_case();
    const PairList list = listed(p, skin);
    std::vector<std::vector<std::uint32_t>> expected(p.size());
    for (std::uint32_t k = 0; k < list.rows(); ++k) expected[list.partner[k]].push_back(k);
    for (std::size_t j = 0; j < p.size(); ++j) {
      const std::vector<std::uint32_t> incoming(
          list.incoming.begin() + static_cast<std::ptrdiff_t>(list.incoming_first[j]),
          list.incoming.begin() + static_cast<std::ptrdiff_t>(list.incoming_first[j + 1]));
      RC_ASSERT(incoming == expected[j]);
    }
  }));
}

// A row must go on meaning its image while particles and faces pass each other.
TEST(FindPairs, RowsFollowTheirImage) {
  EXPECT_TRUE(test::holds(500, [] {
    auto [p, skin] = random_case();
    Dice dice(test::any_seed());
    const PairList list = listed(p, skin);
    if (list.quarter.empty()) return;
    for (std::uint32_t i = 0; i < p.size(); ++i)
      for (std::uint64_t k = list.first[i]; k < list.first[i + 1]; ++k) {
        const Fraction& a = p.fraction[i];
        const Fraction& b = p.fraction[list.partner[k]];
        const Vec3<double> before = row_difference(a, b, list.quarter[k]);
        const Vec3<double> move = dice.vector(0.37);
        const Fraction m = to_fraction(move);
        const Vec3<double> after = row_difference({a.x + m.x, a.y + m.y, a.z + m.z}, b, list.quarter[k]);
        const Vec3<double> error = after - before - move;
        RC_ASSERT(norm(error) < 1e-14 * (1 + norm(before)));
      }
  }));
}

// A bin as wide as a contact, spheres that touch by less than a place in the cell is rounded.
TEST(FindPairs, LosesNoTouchAtTheEdgeOfABin) {
  Packing p;
  p.resize(2);
  p.radius = {0.5, 0.5};
  for (int bins : {10, 1000, 100000}) {
    p.cell.edges = {double(bins), double(bins), double(bins)};
    const std::uint64_t width = to_fixed(1.0 / bins);
    for (int bin : {1, bins / 3, bins - 1})
      for (int shift = -4096; shift <= 4096; shift += 128)
        for (std::uint64_t overlap : {256, 512, 1024, 4096}) {
          p.fraction[0].x = to_fixed(static_cast<double>(bin) / bins) + static_cast<std::uint64_t>(shift);
          p.fraction[1].x = p.fraction[0].x - width + overlap;
          if (norm(p.cell.edges * nearest_difference(p.fraction[0], p.fraction[1])) >= 1) continue;
          EXPECT_EQ(listed(p, {0, 0}).rows(), 1u)
              << bins << " bins, edge " << bin << ", shift " << shift << ", overlap " << overlap;
        }
  }
}

TEST(FindPairs, RefusesASphereThatReachesAcrossTooManyCells) {
  Packing p;
  p.resize(1);
  p.radius = {20};
  p.cell.edges = {1, 1, 1};
  EXPECT_THROW(listed(p, {0, 0}), NumericalFailure);
}

}  // namespace
}  // namespace furnas
