#include <gtest/gtest.h>

#include <vector>

#include "tests/engine/laws/every_law.h"
#include "tests/engine/support/setups.h"

namespace furnas {
namespace {

/// The vector of the antisymmetric part of sum(branch (x) force) = sum(branch x force).
Vec3<double> antisymmetric(const Packing& p) {
  const Eigen::Matrix3d& s = p.stress.contacts;
  return {s(1, 2) - s(2, 1), s(2, 0) - s(0, 2), s(0, 1) - s(1, 0)};
}

Vec3<double> sum(const std::vector<Vec3<double>>& vectors) {
  Vec3<double> total;
  for (const Vec3<double>& v : vectors) total += v;
  return total;
}

template <class Law>
class StressSymmetry : public testing::Test {};
TYPED_TEST_SUITE(StressSymmetry, EveryFrictionLaw, LawName);

// T34: the antisymmetric part of the stress times the volume is the opposite of all torques of the contacts,
// when the lever arms meet in the contact. With the full radii (legacy) arms are too long by the overlap.
TYPED_TEST(StressSymmetry, IsBrokenByTheTorquesAlone) {
  const auto simulation = make_simulation(model_of<TypeParam>({.friction = 0.3}), squeezed(1e-2));
  double largest = 0;
  for (int step = 0; step < 100; ++step) {
    simulation->advance(1);
    const Packing p = simulation->packing();
    Vec3<double> expected = sum(p.torque);
    if (!TypeParam::synchronized)
      for (const Contact& c : p.contacts) expected += (c.overlap / norm(c.branch)) * cross(c.branch, c.force);
    const double scale = p.stress.contacts.norm();
    ASSERT_LT(norm(antisymmetric(p) + expected), 1e-12 * scale) << step;
    largest = std::max(largest, norm(antisymmetric(p)) / scale);
  }
  EXPECT_GT(largest, 1e-4);  // there was something to compare
}

// T34: without friction forces are central and the stress is symmetric.
TYPED_TEST(StressSymmetry, HoldsWithoutFriction) {
  const Packing p = after(model_of<TypeParam>({.friction = 0}), squeezed(1e-2), 100);
  EXPECT_LT(norm(antisymmetric(p)), 1e-12 * p.stress.contacts.norm());
}

// T34: as a packing comes to rest each particle's torques balance, and the stress becomes symmetric. With
// arms that are too long (legacy) it never does. How fast a packing settles differs from one to the next, so
// falls to a hundredth count: 1e-3 of the stress at first, below 1e-6 at the end.
TYPED_TEST(StressSymmetry, ReturnsAsThePackingSettles) {
  const auto simulation = make_simulation(model_of<TypeParam>({.friction = 0.3}), squeezed(1e-2));
  const auto share_of_stress = [](const Packing& p, const Vec3<double>& v) {
    return norm(v) / p.stress.contacts.norm();
  };
  simulation->advance(20);
  const Packing moving = simulation->packing();
  simulation->advance(10000);
  const Packing settled = simulation->packing();
  const double torque = share_of_stress(settled, sum(settled.torque));
  EXPECT_LT(torque, 0.01 * share_of_stress(moving, sum(moving.torque)));
  if (TypeParam::synchronized)
    EXPECT_LT(share_of_stress(settled, antisymmetric(settled)),
              0.01 * share_of_stress(moving, antisymmetric(moving)));
  else
    EXPECT_GT(share_of_stress(settled, antisymmetric(settled)), 100 * torque);
}

}  // namespace
}  // namespace furnas
