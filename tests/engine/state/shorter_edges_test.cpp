#include "engine/state/shorter_edges.h"

#include <gtest/gtest.h>

namespace furnas {
namespace {

TEST(ShorterEdges, AreThoseOfTheSameLattice) {
  Packing p;
  p.resize(2);
  p.cell.edges = {.xx = 4, .yy = 5, .zz = 6, .yz = 2.6, .xz = -2.2, .xy = 2.1};
  p.fraction = {to_fraction({0.25, 0.5, 0.75}), to_fraction({0.9, 0.1, 0.2})};
  p.image = {{{1, -2, 3}, {0, 0, -1}}};
  const Packing before = p;
  EXPECT_TRUE(is_tilted(p.cell.edges, 0.5));
  EXPECT_FALSE(is_tilted(p.cell.edges, 0.55));
  EXPECT_FALSE(shorten_edges(p, 0.55));
  ASSERT_TRUE(shorten_edges(p, 0.5));
  EXPECT_FALSE(is_tilted(p.cell.edges, 0.5));
  for (std::size_t k = 0; k < 2; ++k) EXPECT_LT(norm(p.unwrapped(k) - before.unwrapped(k)), 1e-13);
  EXPECT_EQ(p.cell.volume(), before.cell.volume());
}

}  // namespace
}  // namespace furnas
