#include "engine/state/species.h"

#include <gtest/gtest.h>

namespace furnas {
namespace {

using enum Species;
using List = std::vector<Species>;

TEST(SpeciesBySize, TheLargerOfTwoSizesIsLarge) {
  EXPECT_EQ(species_by_size({0.5, 1.5, 1.5 - 1e-9, 0.5}), (List{small, large, large, small}));
  EXPECT_EQ(species_by_size({0.5, 0.5}), (List{large, large}));
  EXPECT_TRUE(species_by_size({}).empty());
}

TEST(SpeciesBySize, MoreSizesAreOneSpecies) {
  EXPECT_EQ(species_by_size({0.5, 1.5, 0.7}), (List{large, large, large}));
}

TEST(SpeciesByType, TwoTypesAreTheTwoSpecies) {
  EXPECT_EQ(species_by_type({0.5, 1.5}, {1, 2}), (List{small, large})) << "whichever type is larger";
  EXPECT_EQ(species_by_type({0.5, 1.5}, {7, 3}), (List{small, large}));
  EXPECT_EQ(species_by_type({0.5, 0.5, 0.5}, {2, 1, 2}), (List{small, large, small}))
      << "of equal ones the lower";
  EXPECT_EQ(species_by_type({1, 0.6, 0.5}, {4, 9, 9}), (List{large, small, small})) << "by their mean sizes";
}

TEST(SpeciesByType, SizesDecideWhereTypesDoNotTellThemApart) {
  EXPECT_EQ(species_by_type({0.5, 1.5, 0.5}, {1, 1, 1}), (List{small, large, small})) << "one type";
  EXPECT_EQ(species_by_type({0.5, 1.5, 0.5}, {1, 2, 3}), (List{small, large, small})) << "three types";
  EXPECT_EQ(species_by_type({0.5, 1.5, 0.5}, {1, 1, 2}), (List{small, large, small}))
      << "a type of both sizes";
  EXPECT_EQ(species_by_type({0.5, 1.5}, {}), (List{small, large})) << "no types";
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
  const auto packing = [](const std::vector<double>& radius, const List& species) {
    Packing p;
    p.resize(radius.size());
    p.radius = radius, p.species = species;
    return p;
  };
  EXPECT_FALSE(is_polydisperse(packing({0.5, 1.5}, {small, large})));
  EXPECT_FALSE(is_polydisperse(packing({0.5, 0.5}, {small, large}))) << "one size in two species";
  EXPECT_TRUE(is_polydisperse(packing({0.5, 1.5, 1.6}, {small, large, large})));
  EXPECT_FALSE(is_one_polydisperse_species(packing({0.5, 1.5, 1.6}, {small, large, large})));
  EXPECT_TRUE(is_one_polydisperse_species(packing({0.5, 1.5}, {large, large})));
  EXPECT_FALSE(is_one_polydisperse_species(packing({1.5, 1.5}, {large, large})));
}

}  // namespace
}  // namespace furnas
