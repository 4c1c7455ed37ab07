#include "engine/analysis/fabric.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/trials/crystal.h"
#include "tests/engine/support/dice.h"
#include "tests/engine/support/graph_packing.h"
#include "tests/engine/support/setups.h"

namespace furnas {
namespace {

using test::Dice;

Packing packing_of_branches(const std::vector<Vec3<double>>& branches) {
  Packing p = packing_of_graph(2, Edges(branches.size(), {0, 1}));
  for (std::size_t n = 0; n < branches.size(); ++n) p.contacts[n].branch = branches[n];
  return p;
}

Fabric fabric_of(const Packing& p) { return fabric(p, all_contacts(p)); }

TEST(Fabric, OfParallelContactsIsADirection) {
  // Neither the length of a branch nor its sign matters.
  const Fabric f = fabric_of(packing_of_branches({{0, 0, 0.5}, {0, 0, -3}, {0, 0, 1}}));
  EXPECT_EQ(f.tensor, (std::array<double, 6>{0, 0, 1, 0, 0, 0}));
  EXPECT_DOUBLE_EQ(f.anisotropy(), 1);
  EXPECT_DOUBLE_EQ(f.anisotropy_by_chance(), 1 / std::sqrt(3.0));
  const Fabric diagonal = fabric_of(packing_of_branches({{1, 2, 2}}));
  const std::array<double, 6> expected{1. / 9, 4. / 9, 4. / 9, 2. / 9, 2. / 9, 4. / 9};
  for (std::size_t k = 0; k < 6; ++k) EXPECT_NEAR(diagonal.tensor[k], expected[k], 1e-15) << k;
  EXPECT_NEAR(diagonal.anisotropy(), 1, 1e-15);
}

TEST(Fabric, WithAnAxisHasTheDifferenceOfItsEigenvaluesAsAnisotropy) {
  // n_z^2 = 0.64 and the rest shared by x and y: 0.64, 0.18, 0.18.
  const Fabric f =
      fabric_of(packing_of_branches({{0.6, 0, 0.8}, {-0.6, 0, 0.8}, {0, 0.6, 0.8}, {0, -0.6, 0.8}}));
  EXPECT_NEAR(f.tensor[2], 0.64, 1e-15);
  EXPECT_NEAR(f.tensor[0], 0.18, 1e-15);
  EXPECT_NEAR(f.anisotropy(), 0.64 - 0.18, 1e-15);
}

TEST(Fabric, OfCubicCrystalsIsIsotropic) {
  const Model model = model_of<HookeSynchronized>({});
  for (const Packing& crystal : {simple_cubic(0.95, 4), face_centred(0.95, 3), face_centred_primitive(0.95),
                                 reskewed(face_centred(0.95, 3), 1, -1, 2)}) {
    const Packing p = with_forces(model, crystal);
    ASSERT_GE(p.contacts.size(), 3 * p.size());
    const Fabric f = fabric_of(p);
    // Branches come from 53-bit places in the cell.
    for (std::size_t k = 0; k < 6; ++k) EXPECT_NEAR(f.tensor[k], k < 3 ? 1.0 / 3 : 0, 1e-13) << k;
    EXPECT_LT(f.anisotropy(), 1e-12);
  }
}

/// The mean square over many sets of random directions; one set has it with a spread of sqrt(2/5), since five
/// components are free.
TEST(Fabric, OfRandomDirectionsHasTheAnisotropyOfChance) {
  Dice dice(4);
  constexpr int sets = 3000;
  constexpr std::size_t contacts = 50;
  double squares = 0;
  for (int n = 0; n < sets; ++n) {
    std::vector<Vec3<double>> branches;
    while (branches.size() < contacts) branches.push_back(dice.direction());
    const Fabric f = fabric_of(packing_of_branches(branches));
    EXPECT_NEAR(f.tensor[0] + f.tensor[1] + f.tensor[2], 1, 1e-14);
    squares += f.anisotropy() * f.anisotropy();
  }
  EXPECT_NEAR(squares / sets * contacts, 1, 4 * std::sqrt(0.4 / sets));
}

TEST(Fabric, OfNothingIsNothing) {
  const Fabric f = fabric_of(packing_of_branches({}));
  EXPECT_EQ(f.tensor, (std::array<double, 6>{}));
  EXPECT_EQ(f.anisotropy(), 0);
}

}  // namespace
}  // namespace furnas
