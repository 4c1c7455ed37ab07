#include "viz/spheres.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "viz/visible.h"

namespace furnas {
namespace {

Packing two_particles() {
  Packing packing;
  packing.cell.edges = {4, 5, 6, 0.5, -1, 0.25};
  packing.resize(2);
  packing.radius = {1, 0.5};
  packing.fraction = {to_fraction({0.25, 0.25, 0.25}), to_fraction({0.75, 0.5, 0.125})};
  return packing;
}

std::vector<Sphere> of(const Packing& packing, const std::array<int, 3>& times,
                       const std::optional<Slice>& slice = {}) {
  return spheres_of(packing, std::vector<Rgb>(packing.size(), {1, 2, 3}), times, slice);
}

TEST(SpheresOf, RepeatTheCellAlongItsEdges) {
  const Packing packing = two_particles();
  const auto once = of(packing, {1, 1, 1});
  ASSERT_EQ(once.size(), 2U);
  EXPECT_NEAR(once[1].centre.x, packing.position(1).x, 1e-6);
  EXPECT_EQ(once[1].radius, 0.5F);
  EXPECT_EQ(once[1].colour, (Rgb{1, 2, 3}));
  const auto repeated = of(packing, {1, 2, 3});
  ASSERT_EQ(repeated.size(), 12U);
  const Vec3<double> last = packing.position(1) + packing.cell.edges * Vec3<double>{0, 1, 2};
  EXPECT_NEAR(repeated[11].centre.x, last.x, 1e-5);
  EXPECT_NEAR(repeated[11].centre.y, last.y, 1e-5);
  EXPECT_NEAR(repeated[11].centre.z, last.z, 1e-5);
}

TEST(SpheresOf, ASliceIsAFractionOfAllThatIsRepeated) {
  const Packing packing = two_particles();
  EXPECT_EQ(of(packing, {1, 1, 1}, Slice{2, 0.2, 0.3}).size(), 1U);
  EXPECT_EQ(of(packing, {1, 1, 1}, Slice{2, 0.3, 1}).size(), 0U);
  EXPECT_EQ(of(packing, {2, 1, 1}, Slice{0, 0.5, 1}).size(), 2U);
  EXPECT_EQ(of(packing, {1, 4, 1}, Slice{1, 0, 0.1}).size(), 1U);
}

/// Spheres of three sizes at random places, some in front of others.
std::vector<Sphere> crowd(std::size_t count) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> place(-10, 10), kind(0, 1);
  std::vector<Sphere> spheres(count);
  for (Sphere& s : spheres) {
    const float k = kind(random);
    s = {{place(random), place(random), place(random)}, k < 0.02F ? 4.0F : k < 0.1F ? 1.5F : 0.5F, {}};
  }
  return spheres;
}

/// Which sphere a ray through a place of the frame meets first; none: -1.
std::ptrdiff_t first_met(const std::vector<Sphere>& spheres, const View& view, double x, double y) {
  const Vec3<double> ray = (x * view.slope_x) * view.right + (y * view.slope_y) * view.up - view.toward;
  std::ptrdiff_t first = -1;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < spheres.size(); ++k) {
    const Sphere& s = spheres[k];
    const Vec3<double> c = Vec3<double>{s.centre.x, s.centre.y, s.centre.z} - view.eye;
    const double a = dot(ray, ray), b = dot(ray, c);
    const double root = b * b - a * (dot(c, c) - double(s.radius) * s.radius);
    if (root < 0) continue;
    const double depth = (b - std::sqrt(root)) / a;
    if (depth < nearest) nearest = depth, first = static_cast<std::ptrdiff_t>(k);
  }
  return first;
}

/// The colour says which sphere it is.
TEST(Visible, KeepsEverySphereThatAnyPlaceOfAPixelSees) {
  constexpr int width = 180, height = 140;
  std::vector<Sphere> spheres = crowd(3000);
  for (std::size_t k = 0; k < spheres.size(); ++k)
    spheres[k].colour = {std::uint8_t(k % 256), std::uint8_t(k / 256), 0};
  ViewFit fit(double(width) / height, 40);
  for (const Sphere& s : spheres) fit.add({s.centre.x, s.centre.y, s.centre.z}, s.radius);
  const View view = fit.view();

  std::vector<bool> kept(spheres.size());
  const auto seen = visible(spheres, view, width, height);
  for (const Sphere& s : seen) kept[s.colour[0] + 256U * s.colour[1]] = true;
  std::vector<bool> shows(spheres.size());
  std::size_t showing = 0;
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column)
      for (const double shift : {0.1, 0.5, 0.9}) {
        const auto k =
            first_met(spheres, view, 2 * (column + shift) / width - 1, 2 * (row + 1 - shift) / height - 1);
        if (k < 0) continue;
        if (!shows[static_cast<std::size_t>(k)]) ++showing;
        shows[static_cast<std::size_t>(k)] = true;
        ASSERT_TRUE(kept[static_cast<std::size_t>(k)]) << "sphere " << k << " at " << column << ' ' << row;
      }
  EXPECT_GT(showing, 100U);
  EXPECT_LT(seen.size(), 3 * showing);
  EXPECT_LT(seen.size(), spheres.size() / 2);
}

}  // namespace
}  // namespace furnas
