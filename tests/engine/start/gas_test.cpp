#include "engine/start/gas.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/base/random.h"
#include "engine/base/require.h"
#include "engine/base/sphere.h"
#include "engine/start/mixture.h"

namespace furnas {
namespace {

/// Radii spread over a factor of 12, in no order.
std::vector<double> many_radii(std::size_t count) {
  std::vector<double> radii(count);
  for (std::size_t k = 0; k < count; ++k) {
    const auto words = philox({static_cast<std::uint32_t>(k), 0, 0, 7}, 1);
    radii[k] = 0.5 * std::exp(2.5 * words[0] / 4294967296.0);
  }
  radii[count / 2] = 0.5;
  return radii;
}

TEST(DiluteGas, KeepsRadiiAndTheirOrder) {
  const auto radii = many_radii(300);
  const Packing p = dilute_gas(radii, {.start_fraction = 0.2, .seed = 3});
  EXPECT_EQ(p.radius, radii);
  EXPECT_NEAR(p.fraction_filled(), 0.2, 1e-13);
  for (std::size_t k = 0; k < p.size(); ++k) {
    EXPECT_EQ(p.mass[k], sphere_mass(radii[k]));
    EXPECT_EQ(p.species[k], Species::large) << "many sizes are no two species";
  }
}

TEST(DiluteGas, NoTwoSpheresOfManySizesTouch) {
  const Packing p = dilute_gas(many_radii(400), {.start_fraction = 0.25});
  const double length = p.cell.edges.xx;
  for (std::size_t i = 0; i < p.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const Vec3<double> d = length * nearest_difference(p.fraction[i], p.fraction[j]);
      ASSERT_GE(norm(d), p.radius[i] + p.radius[j]) << i << ' ' << j;
    }
}

/// So a list of two sizes is the mixture, to the bit.
TEST(DiluteGas, OfTwoSizesIsTheMixture) {
  const Mixture mixture{
      .size_ratio = 3, .small_fraction = 0.3, .large = 20, .start_fraction = 0.2, .seed = 5};
  const Packing wanted = dilute_start(mixture);
  std::vector<double> reversed = wanted.radius;
  std::reverse(reversed.begin(), reversed.end());
  const Packing list = dilute_gas(reversed, {.start_fraction = 0.2, .seed = 5});
  const std::size_t large = 20, small = wanted.size() - large;
  for (std::size_t k = 0; k < large; ++k) {
    EXPECT_EQ(list.species[small + k], Species::large);
    EXPECT_NEAR(norm(nearest_difference(list.fraction[small + k], wanted.fraction[k])), 0, 1e-15);
  }
  for (std::size_t k = 0; k < small; ++k) EXPECT_EQ(list.species[k], Species::small);
}

TEST(DiluteGas, OfSpheresThatFillTheirCellIsRefused) {
  EXPECT_THROW(dilute_gas({0.5, 0.5}, {.start_fraction = 0.7}), InputError);
  EXPECT_THROW(dilute_gas({20, 0.5}, {.start_fraction = 0.7}), InputError);
}

TEST(DiluteGas, RefusesWhatIsNoSphereAndNoGas) {
  EXPECT_THROW(dilute_gas({}, {}), InputError);
  for (const double radius : {0.0, -0.5, std::nan(""), HUGE_VAL})
    EXPECT_THROW(dilute_gas({0.5, radius}, {}), InputError) << radius;
  for (const double fraction : {0.0, -0.1, std::nan("")})
    EXPECT_THROW(dilute_gas({0.5, 0.5}, {.start_fraction = fraction}), InputError) << fraction;
}

}  // namespace
}  // namespace furnas
