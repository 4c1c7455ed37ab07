#include "io/particle_rows.h"

#include <cmath>
#include <limits>

#include "tests/io/packings.h"

namespace furnas {
namespace {

TEST(Wrap, CountsCellsConsistentlyWithTheFraction) {
  for (const double place :
       {0.0, 0.25, 0.5, 0.999, 1.0, 1.5, -0.25, -1.0, -1e-18, -1e-25, 1e-25, 1 - 1e-16, 12345.75}) {
    Fraction fraction;
    Image image{};
    ASSERT_TRUE(wrap({place, 0, 0}, fraction, image));
    EXPECT_NEAR(in_unit_cell(fraction).x + image[0], place, 1e-15 * (1 + std::abs(place))) << place;
  }
}

TEST(Wrap, RefusesWhatCannotBeCounted) {
  Fraction fraction;
  Image image{};
  for (const double place : {1e10, -1e300, std::nan(""), std::numeric_limits<double>::infinity()})
    EXPECT_FALSE(wrap({0, place, 0}, fraction, image)) << place;
  image = {2'000'000'000, 0, 0};
  EXPECT_FALSE(wrap({5e8, 0, 0}, fraction, image));
}

TEST(InEdges, IsTheInverseOfTheEdges) {
  const Packing p = random_packing(3);
  const Vec3<double> s{0.3, -0.7, 5.1};
  const Vec3<double> back = in_edges(p.cell.edges, p.cell.edges * s);
  EXPECT_LT(norm(back - s), 1e-14);
}

TEST(CheckPacking, RefusesWhatIsNotFinite) {
  const Packing good = random_packing(1);
  EXPECT_NO_THROW(check_packing(good, "file"));
  const auto refused = [&](auto change) {
    Packing bad = good;
    change(bad);
    return input_error([&] { check_packing(bad, "file"); }).starts_with("file: ");
  };
  const double nan = std::nan("");
  EXPECT_TRUE(refused([&](Packing& p) { p.resize(0); }));
  EXPECT_TRUE(refused([&](Packing& p) { p.radius[3] = 0; }));
  EXPECT_TRUE(refused([&](Packing& p) { p.mass[3] = -1; }));
  EXPECT_TRUE(refused([&](Packing& p) { p.velocity[3].y = nan; }));
  EXPECT_TRUE(refused([&](Packing& p) { p.spin[3].y = nan; }));
  EXPECT_TRUE(refused([&](Packing& p) { p.force[3].y = nan; }));
  EXPECT_TRUE(refused([&](Packing& p) { p.cell.edges.yy = 0; }));
  EXPECT_TRUE(refused([&](Packing& p) { p.cell.rate.xy = nan; }));
  EXPECT_TRUE(refused([&](Packing& p) { p.contacts[0].j = 40; }));
  EXPECT_TRUE(refused([&](Packing& p) { p.contacts[0].history.x = nan; }));
}

}  // namespace
}  // namespace furnas
