#include "io/file_cell.h"

#include <rapidcheck.h>

#include "io/particle_rows.h"
#include "tests/engine/support/property.h"
#include "tests/io/packings.h"

namespace furnas {
namespace {

TEST(FileCell, TurnsNothingThatLiesAsItShould) {
  const FileCell cell({4, 0, 0}, {1, 5, 0}, {-1, 2, 6}, {1, 2, 3});
  EXPECT_FALSE(cell.is_turned());
  EXPECT_EQ(cell.edges(), (Triangle{.xx = 4, .yy = 5, .zz = 6, .yz = 2, .xz = -1, .xy = 1}));
  EXPECT_EQ(cell.turned({7, 8, 9}), (Vec3<double>{7, 8, 9}));
  EXPECT_EQ(cell.origin(), (Vec3<double>{1, 2, 3}));
}

/// Lengths, angles and handedness of vectors stay, and the lattice is the same: a whole cell along an edge of
/// the file is a whole cell along one of furnas.
TEST(FileCell, TurnsAnyCellRigidly) {
  EXPECT_TRUE(test::holds(300, [] {
    std::mt19937_64 random(test::any_seed());
    const auto real = [&] { return std::uniform_real_distribution(-5.0, 5.0)(random); };
    const auto vector = [&] { return Vec3<double>{real(), real(), real()}; };
    const Vec3<double> a = vector(), b = vector(), c = vector(), origin = vector();
    RC_PRE(std::abs(dot(a, cross(b, c))) > 1);
    const FileCell cell(a, b, c, origin);
    const Vec3<double> v = vector(), w = vector();
    RC_ASSERT(std::abs(dot(v, w) - dot(cell.turned(v), cell.turned(w))) < 1e-12);
    RC_ASSERT(norm(cell.turned(cross(v, w)) - cross(cell.turned(v), cell.turned(w))) < 1e-12);
    const Triangle& h = cell.edges();
    RC_ASSERT(h.xx > 0 && h.yy > 0 && h.zz > 0);
    RC_ASSERT(std::abs(h.determinant() - std::abs(dot(a, cross(b, c)))) < 1e-11);
    const Vec3<double> s{0.25, 0.5, 0.75};
    const Vec3<double> at = origin + s.x * a + s.y * b + s.z * c;
    RC_ASSERT(norm(cell.place_of(at) - cell.place_of_scaled(s)) < 1e-11);
    const Image image = cell.image_of({1, -2, 3});
    const Vec3<double> moved{double(image[0]), double(image[1]), double(image[2])};
    RC_ASSERT(norm(cell.place_of(at + a - 2.0 * b + 3.0 * c) - (cell.place_of(at) + moved)) < 1e-11);
  }));
}

}  // namespace
}  // namespace furnas
