#include "engine/minimize/shift.h"

#include <gtest/gtest.h>

#include "engine/base/parallel.h"
#include "tests/engine/support/dice.h"
#include "tests/engine/support/same_packing.h"

namespace furnas {
namespace {

Shift shift_of_seed(std::size_t particles, std::uint64_t seed) {
  test::Dice dice(seed);
  Shift shift(particles);
  for (Vec3<double>& u : shift.displacement) u = dice.vector(1);
  shift.strain = {dice.between(-1, 1), dice.between(-1, 1), dice.between(-1, 1),
                  dice.between(-1, 1), dice.between(-1, 1), dice.between(-1, 1)};
  return shift;
}

TEST(Shift, CountsStrainAndDisplacements) {
  Shift a(2), b(2);
  a.displacement = {{1, 2, 3}, {0, 0, 4}};
  b.displacement = {{1, 1, 1}, {5, 5, 5}};
  a.strain = {1, 2, 3, 4, 5, 6};
  b.strain = {1, 1, 1, 1, 1, 2};
  EXPECT_EQ(dot(a, b), 6 + 20 + 27);
  EXPECT_EQ(add_and_dot(a, 2, b, b), 53 + 2 * dot(b, b));
  EXPECT_EQ(a.displacement[1], (Vec3<double>{10, 10, 14}));
  EXPECT_EQ(a.strain, (Triangle{3, 4, 5, 6, 7, 10}));
  add(a, -2, b, a);
  EXPECT_EQ(a.displacement[0], (Vec3<double>{1, 2, 3}));
  multiply(b, a, a);
  EXPECT_EQ(a.displacement[1], (Vec3<double>{0, 0, 20}));
  EXPECT_EQ(a.strain, (Triangle{1, 2, 3, 4, 5, 12}));
}

TEST(Shift, SumsHaveTheSameBitsForAnyThreads) {
  const Shift a = shift_of_seed(5000, 1), b = shift_of_seed(5000, 2);
  double one = 0;
  Workers(1).run([&] { one = dot(a, b); });
  for (int threads : {2, 3})
    Workers(threads).run([&] { EXPECT_TRUE(test::same_bits(dot(a, b), one)) << threads; });
}

}  // namespace
}  // namespace furnas
