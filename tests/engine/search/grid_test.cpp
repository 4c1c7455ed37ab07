#include "engine/search/grid.h"

#include <gtest/gtest.h>

namespace furnas {
namespace {

std::int64_t bins_of(const Triangle& edges, double cutoff, std::size_t particles) {
  const Grid grid = make_grid(edges, cutoff, std::vector<Fraction>(particles), 0, particles);
  return grid.count[0] * grid.count[1] * grid.count[2];
}

// Bins of a cell that is dilute, flat or a needle: about two for each particle at most.
TEST(Grid, HasNoMoreBinsThanItsParticlesNeed) {
  constexpr double cutoff = 1.1;
  EXPECT_EQ(bins_of({.xx = 11, .yy = 11, .zz = 11}, cutoff, 1000), 1000) << "as wide as the cutoff";
  for (const Triangle& edges :
       {Triangle{.xx = 1e4, .yy = 1e4, .zz = 1e4}, Triangle{.xx = 1e4, .yy = 1e4, .zz = 1},
        Triangle{.xx = 1, .yy = 1e12, .zz = 1}, Triangle{.xx = 2.3, .yy = 1e9, .zz = 5}}) {
    const std::int64_t bins = bins_of(edges, cutoff, 10);
    EXPECT_LE(bins, 28) << edges.xx << " " << edges.yy << " " << edges.zz;
    EXPECT_GE(bins, 8);
  }
}

}  // namespace
}  // namespace furnas
