#include "engine/state/species.h"

#include <gtest/gtest.h>

namespace furnas {
namespace {

using SpeciesList = std::vector<Species>;

/// "lss" for large, small, small.
SpeciesList spelled(const std::string& letters) {
  SpeciesList species;
  for (const char letter : letters) species.push_back(letter == 'l' ? Species::large : Species::small);
  return species;
}

TEST(SpeciesBySize, TheLargerOfTwoSizesIsLarge) {
  EXPECT_EQ(species_by_size({0.5, 1.5, 1.5 - 1e-9, 0.5}), spelled("slls"));
  EXPECT_EQ(species_by_size({0.5, 0.5}), spelled("ll"));
  EXPECT_TRUE(species_by_size({}).empty());
}

TEST(SpeciesBySize, MoreSizesAreOneSpecies) { EXPECT_EQ(species_by_size({0.5, 1.5, 0.7}), spelled("lll")); }

TEST(SpeciesByType, TwoTypesAreTheTwoSpecies) {
  EXPECT_EQ(species_by_type({0.5, 1.5}, {1, 2}), spelled("sl")) << "whichever type is larger";
  EXPECT_EQ(species_by_type({0.5, 1.5}, {7, 3}), spelled("sl"));
  EXPECT_EQ(species_by_type({0.5, 0.5, 0.5}, {2, 1, 2}), spelled("sls")) << "of equal ones the lower";
  EXPECT_EQ(species_by_type({1, 0.6, 0.5}, {4, 9, 9}), spelled("lss")) << "by their mean sizes";
}

TEST(SpeciesByType, SizesDecideWhereTypesDoNotTellThemApart) {
  EXPECT_EQ(species_by_type({0.5, 1.5, 0.5}, {1, 1, 1}), spelled("sls")) << "one type";
  EXPECT_EQ(species_by_type({0.5, 1.5, 0.5}, {1, 2, 3}), spelled("sls")) << "three types";
  EXPECT_EQ(species_by_type({0.5, 1.5, 0.5}, {1, 1, 2}), spelled("sls")) << "a type of both sizes";
  EXPECT_EQ(species_by_type({0.5, 1.5}, {}), spelled("sl")) << "no types";
}

TEST(SizesOf, CountsThoseThatDiffer) {
  const Sizes sizes = sizes_of({0.5, 1.5, 1.5 - 1e-9, 0.7, 0.5});
  EXPECT_EQ(sizes.count, 3U);
  EXPECT_EQ(sizes.smallest, 1);
  EXPECT_EQ(sizes.largest, 3);
  EXPECT_EQ(sizes_of({0.5, 0.5}).count, 1U);
  EXPECT_EQ(sizes_of({0.5, 2}).count, 2U);
  EXPECT_EQ(sizes_of({}).count, 0U);
}

TEST(IsPolydisperse, WhereASpeciesHasSeveralSizes) {
  const auto packing = [](const std::vector<double>& radius, const SpeciesList& species) {
    Packing p;
    p.resize(radius.size());
    p.radius = radius, p.species = species;
    return p;
  };
  EXPECT_FALSE(is_polydisperse(packing({0.5, 1.5}, spelled("sl"))));
  EXPECT_FALSE(is_polydisperse(packing({0.5, 0.5}, spelled("sl")))) << "one size in two species";
  EXPECT_TRUE(is_polydisperse(packing({0.5, 1.5, 1.6}, spelled("sll"))));
  EXPECT_FALSE(is_one_polydisperse_species(packing({0.5, 1.5, 1.6}, spelled("sll"))));
  EXPECT_TRUE(is_one_polydisperse_species(packing({0.5, 1.5}, spelled("ll"))));
  EXPECT_FALSE(is_one_polydisperse_species(packing({1.5, 1.5}, spelled("ll"))));
}

}  // namespace
}  // namespace furnas
