#include "engine/state/cell.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "tests/engine/support/property.h"
#include "tests/engine/support/random_packing.h"

namespace furnas {
namespace {

Eigen::Matrix3d dense(const Triangle& t) {
  Eigen::Matrix3d m;
  m << t.xx, t.xy, t.xz, 0, t.yy, t.yz, 0, 0, t.zz;
  return m;
}

TEST(Triangle, IsTheMatrixItStandsFor) {
  EXPECT_TRUE(test::holds(500, [] {
    test::Dice dice(test::any_seed());
    const Triangle a = test::random_edges(dice, dice.between(0.1, 100));
    const Triangle b = test::random_edges(dice, dice.between(0.1, 100));
    const Vec3<double> v = dice.vector(3);
    const double scale = dense(a).norm() * dense(b).norm();
    RC_ASSERT((dense(product(a, b)) - dense(a) * dense(b)).norm() <= 1e-15 * scale);
    RC_ASSERT((dense(inverse(a)) - dense(a).inverse()).norm() <= 1e-14 * dense(a).inverse().norm());
    RC_ASSERT((dense(product(a, inverse(a))) - Eigen::Matrix3d::Identity()).norm() <= 1e-14);
    const Vec3<double> av = a * v;
    const Eigen::Vector3d expected = dense(a) * Eigen::Vector3d(v.x, v.y, v.z);
    RC_ASSERT((Eigen::Vector3d(av.x, av.y, av.z) - expected).norm() <= 1e-14 * expected.norm());
    RC_ASSERT(std::abs(a.determinant() - dense(a).determinant()) <= 1e-13 * a.determinant());
  }));
}

TEST(Cell, HeightIsVolumeOverTheAreaOfAFace) {
  EXPECT_TRUE(test::holds(500, [] {
    test::Dice dice(test::any_seed());
    const Triangle h = test::random_edges(dice, 3);
    const Eigen::Matrix3d m = dense(h);
    const Vec3<double> height = heights(h);
    const double volume = h.determinant();
    const auto area = [&](int a, int b) {
      return Eigen::Vector3d(m.col(a)).cross(Eigen::Vector3d(m.col(b))).norm();
    };
    RC_ASSERT(std::abs(height.x * area(1, 2) - volume) <= 1e-13 * volume);
    RC_ASSERT(std::abs(height.y * area(2, 0) - volume) <= 1e-13 * volume);
    RC_ASSERT(std::abs(height.z * area(0, 1) - volume) <= 1e-13 * volume);
  }));
}

}  // namespace
}  // namespace furnas
