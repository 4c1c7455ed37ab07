#include "engine/trials/wedge.h"

#include <gtest/gtest.h>

#include <iostream>

#include "tests/engine/laws/every_law.h"

namespace furnas {
namespace {

template <class Law>
class Wedge : public testing::Test {};
TYPED_TEST_SUITE(Wedge, EveryFrictionLaw, LawName);

// T18: friction mu holds a wedge of half angle beta if tan beta <= mu. The large spheres approach without
// turning, so with k_t = k_n and gamma_t = gamma_n the springs of both directions answer alike, the sphere
// does not move before it slips, and the threshold is sharp.
TYPED_TEST(Wedge, IsHeldUpToTheAngleOfFriction) {
  for (const WedgedSphere& wedge : {WedgedSphere{2, 0.1},
                                    {2, 0.5},
                                    {5, 0.1},
                                    {5, 0.5},
                                    {10, 0.1},
                                    {10, 0.3},
                                    {20, 0.2},
                                    {40, 0.1},
                                    {40, 0.2}}) {
    const double is = threshold_of(wedge, model_of<TypeParam>({.friction = wedge.friction})).middle();
    std::cout << "size ratio " << wedge.size_ratio << ", friction " << wedge.friction << ": held up to "
              << is / WedgedSphere::degree << " degrees, atan(mu) "
              << wedge.threshold() / WedgedSphere::degree << '\n';
    EXPECT_NEAR(is, wedge.threshold(), 0.1 * WedgedSphere::degree);
  }
}

}  // namespace
}  // namespace furnas
