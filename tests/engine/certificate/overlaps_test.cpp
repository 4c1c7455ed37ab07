#include "engine/certificate/overlaps.h"

#include <gtest/gtest.h>

#include "tests/engine/support/brute_force.h"
#include "tests/engine/support/property.h"
#include "tests/engine/support/random_packing.h"
#include "tests/engine/support/setups.h"

namespace furnas {
namespace {

/// Whether the overlaps are those of all pairs and all images in long double.
bool same_as_brute_force(const Packing& packing) {
  auto expected = test::brute_pairs(packing, 0);
  const auto found = find_overlaps(packing);
  if (found.size() != expected.size()) return false;
  for (const Overlap& o : found) {
    bool known = false;
    for (auto at = expected.begin(); at != expected.end(); ++at) {
      if (std::minmax(o.i, o.j) != std::minmax(at->first.i, at->first.j)) continue;
      const auto& b = at->second.branch;
      const Vec3<double> branch{double(b.x), double(b.y), double(b.z)};
      // A branch is a few edges long; its rounding is that of their product with a fraction.
      if (norm(branch - o.branch) > 1e-13 * packing.cell.edges.trace() &&
          norm(branch + o.branch) > 1e-13 * packing.cell.edges.trace())
        continue;
      expected.erase(at);
      known = true;
      break;
    }
    if (!known) return false;
  }
  return true;
}

// In any cell, of any sizes, on faces and edges of the cell, and where spheres touch several images.
TEST(Overlaps, AreThoseOfAllPairsAndImages) {
  EXPECT_TRUE(test::holds(150, [] {
    test::Dice dice(test::any_seed());
    test::RandomPacking wanted;
    wanted.large = dice.below(4);
    wanted.small = 1 + dice.below(40);
    wanted.size_ratio = dice.between(1, 9);
    wanted.spread = dice.between(0, 0.3);
    wanted.cell = dice.between(1.2, 8);
    RC_ASSERT(same_as_brute_force(test::random_packing(dice, wanted)));
  }));
}

TEST(Overlaps, SayWhichImageTouches) {
  const Packing packing = jammed();
  const auto found = find_overlaps(packing);
  EXPECT_EQ(found.size(), packing.contacts.size());
  for (const Overlap& o : found) {
    const Vec3<double> s = in_unit_cell(packing.fraction[o.i]);
    const Vec3<double> t = in_unit_cell(packing.fraction[o.j]);
    const Vec3<double> cells{double(o.cells[0]), double(o.cells[1]), double(o.cells[2])};
    EXPECT_LT(norm(packing.cell.edges * (s - t - cells) - o.branch), 1e-13);
  }
}

}  // namespace
}  // namespace furnas
