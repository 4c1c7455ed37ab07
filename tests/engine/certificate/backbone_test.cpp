#include "engine/certificate/backbone.h"

#include <gtest/gtest.h>

#include "engine/trials/crystal.h"
#include "tests/engine/support/setups.h"

namespace furnas {
namespace {

constexpr double near = 0.99;  // of two neighbours, so that they overlap

/// Spheres at the places, in a cubic cell.
Packing placed(double edge, const std::vector<Vec3<double>>& places) {
  std::vector<Ball> balls;
  for (const auto& place : places) balls.push_back({.position = place});
  return packing_of(cube(edge), balls);
}

Backbone backbone_of(const Packing& packing, CoreRule rule) {
  static ContactNetwork network;  // bonds point into it
  network = contact_network(packing, {});
  return find_backbone(network, packing.species, rule);
}

Percolation percolation_of(const Packing& packing, int least_contacts = 1) {
  return percolation(backbone_of(packing, {0, least_contacts}));
}

// Directions are counted as independent lattice vectors along which a piece meets its own image.
TEST(Percolation, OfChainsSheetsAndCrystals) {
  std::vector<Vec3<double>> chain;
  std::vector<Vec3<double>> sheet;
  for (int x = 0; x < 4; ++x) {
    chain.push_back({x * near, 1, 1});
    for (int y = 0; y < 4; ++y) sheet.push_back({x * near, y * near, 1});
  }
  EXPECT_EQ(percolation_of(placed(4 * near, chain)).directions, 1);
  EXPECT_EQ(percolation_of(placed(4 * near, sheet)).directions, 2);
  EXPECT_EQ(percolation_of(placed(5, chain)).directions, 0) << "it ends before its image begins";
  for (auto& place : chain) place.x += 3;
  EXPECT_EQ(percolation_of(placed(5, chain)).directions, 0) << "through a face, but not back to itself";
  for (int cells : {1, 2, 3}) {
    EXPECT_EQ(percolation_of(simple_cubic(near, cells)).directions, 3) << cells;
    EXPECT_EQ(percolation_of(reskewed(simple_cubic(near, cells), 1, -1, 2)).directions, 3) << cells;
  }
  EXPECT_EQ(percolation_of(face_centred_primitive(near)).directions, 3);
}

TEST(Percolation, AlongADiagonalIsOneDirection) {
  std::vector<Vec3<double>> diagonal;
  const double step = near / std::sqrt(3);
  for (int k = 0; k < 6; ++k) diagonal.push_back({k * step, k * step, k * step});
  const Percolation found = percolation_of(placed(6 * step, diagonal));
  EXPECT_EQ(found.directions, 1);
  EXPECT_EQ(found.pieces, 1);
}

TEST(Percolation, CountsPieces) {
  std::vector<Vec3<double>> places;
  for (int x = 0; x < 4; ++x)
    for (double y : {0.5, 2.5}) places.push_back({x * near, y, 1});
  for (const Vec3<double>& place : {Vec3<double>{1, 1, 3}, {1, 1 + near, 3}, {1 + near / 2, 1 + near / 2, 3}})
    places.push_back(place);
  const Percolation found = percolation_of(placed(4 * near, places));
  EXPECT_EQ(found.pieces, 3);
  EXPECT_EQ(found.largest_piece, 4);
  EXPECT_EQ(found.directions, 1);
}

// Each sphere of a simple cubic crystal has 6 contacts; without one of them, its 6 neighbours have 5.
TEST(Core, LosesWhoHasTooFewContactsAgainAndAgain) {
  Packing crystal = simple_cubic(near, 3);
  EXPECT_EQ(backbone_of(crystal, {0, 6}).particles.size(), 27u);
  EXPECT_EQ(backbone_of(crystal, {0, 7}).particles.size(), 0u);
  crystal.radius[13] = 0.3;  // touches nobody
  EXPECT_EQ(backbone_of(crystal, {0, 6}).particles.size(), 0u) << "one after the other";
  const Backbone rest = backbone_of(crystal, {0, 5});
  EXPECT_EQ(rest.particles.size(), 26u);
  EXPECT_EQ(rest.bonds.size(), 81u - 6);
  EXPECT_FALSE(rest.contains[13]);
  EXPECT_EQ(rest.rule_breaks, 0);
}

TEST(Core, WeakContactsCountOnlyAboveTheirShare) {
  Packing crystal = simple_cubic(near, 3);
  crystal.radius[13] = 0.5 - 0.0099;  // a hundredth of the overlap of the others
  EXPECT_EQ(backbone_of(crystal, {0, 6}).particles.size(), 27u);
  EXPECT_EQ(backbone_of(crystal, {0.1, 5}).particles.size(), 26u);
}

}  // namespace
}  // namespace furnas
