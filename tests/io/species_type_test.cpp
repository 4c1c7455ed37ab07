#include "io/species_type.h"

#include "io/particle_rows.h"
#include "tests/io/packings.h"

namespace furnas {
namespace {

TEST(SpeciesType, LargeIsOneAndSmallIsTwo) {
  const Packing p = random_packing(1, 5);
  EXPECT_EQ(type_of(p, 2), 1);
  EXPECT_EQ(type_of(p, 0), 2);
  EXPECT_EQ(type_count(p), 2);
  EXPECT_EQ(name_of_type(p, 1), "large");
  EXPECT_EQ(element_of(p, 2), "Ag");
  EXPECT_EQ(element_of(p, 0), "Au");
}

TEST(SpeciesType, TypesOfAFileKeepTheirNumbersAndNames) {
  Packing p = random_packing(1, 3);
  label_by_types(p, {3, 1, 3}, {"Fe", "stone", "a b"});
  EXPECT_EQ(type_count(p), 3);
  EXPECT_EQ(name_of_type(p, 2), "stone");
  EXPECT_EQ(element_of(p, 1), "Fe");
  EXPECT_EQ(element_of(p, 0), "H");
  p.labels.names.clear();
  EXPECT_EQ(name_of_type(p, 1), "1") << "type 1 need not be large";
}

TEST(LabelByTypes, KeepsOnlyWhatSaysMoreThanTheSpecies) {
  Packing p = random_packing(1, 3);  // small, small, large
  label_by_types(p, {2, 2, 1}, {});
  EXPECT_EQ(p.labels, Labels{});
  label_by_types(p, {2, 2, 1}, {"large", "small"});
  EXPECT_EQ(p.labels, Labels{});
  label_by_types(p, {1, 1, 2}, {});
  EXPECT_EQ(p.labels.type, (std::vector{1, 1, 2}));
  EXPECT_EQ(p.species[2], Species::large);
  label_by_types(p, {1, 1, 2}, {"large", "small"});
  EXPECT_EQ(p.species[0], Species::large) << "names count more than sizes";
  label_by_types(p, {0, 0, 0}, {});
  EXPECT_EQ(p.species[2], Species::large);
  label_by_types(p, {2, 2, 1}, {"C", "C"});
  EXPECT_TRUE(p.labels.names.empty()) << "names that tell nothing apart";
}

}  // namespace
}  // namespace furnas
