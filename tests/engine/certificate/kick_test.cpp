#include "engine/certificate/kick.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/certificate/modes.h"
#include "engine/certificate/statics.h"
#include "tests/engine/certificate/chain.h"

namespace furnas {
namespace {

TEST(Kick, GivesTheParticleThatMovesMostTheSpeed) {
  Packing p;
  p.resize(3);
  p.radius = {2, 0.5, 0.5};
  p.velocity[1] = {1, 0, 0};
  Backbone backbone;
  backbone.particles = {0, 1};
  Eigen::VectorXd motion(12);
  motion << 0, 0, 1, 0, 0.6, 0,  // of particle 0: u, R theta
      0, 4, 0, 3, 0, 0;          // of particle 1, whose length is 5
  Kick kick(3);
  kick.add(motion, backbone, p.radius);
  EXPECT_EQ(kick.motions(), 1);
  kick.give(p, 10);
  EXPECT_NEAR(norm(p.velocity[0] - Vec3<double>{0, 0, 2}), 0, 1e-15);
  EXPECT_NEAR(norm(p.spin[0] - Vec3<double>{0, 0.6, 0}), 0, 1e-15) << "R theta is 1.2, R is 2";
  EXPECT_NEAR(norm(p.velocity[1] - Vec3<double>{1, 8, 0}), 0, 1e-15);
  EXPECT_NEAR(norm(p.spin[1] - Vec3<double>{12, 0, 0}), 0, 1e-14);
  EXPECT_EQ(norm(p.velocity[2]), 0) << "a rattler";
}

TEST(Kick, OfNoMotionIsNone) {
  Packing p;
  p.resize(2);
  Backbone backbone;
  backbone.particles = {0, 1};
  Kick kick(2);
  kick.add(Eigen::VectorXd::Zero(6), backbone, p.radius);
  kick.add(Eigen::VectorXd(), Backbone{}, p.radius);
  EXPECT_EQ(kick.motions(), 0);
  kick.give(p, 1);
  for (const auto& v : p.velocity) EXPECT_EQ(norm(v), 0);
}

// The lowest mode of a chain that buckles is its shortest wave: neighbours move against each other, all by
// the same amount, and across the chain.
TEST(Kick, OfAChainThatBucklesIsItsShortestWave) {
  constexpr int length = 12;
  Packing p = test::chain(length);
  const ContactNetwork network = contact_network(p, {});
  const Backbone backbone = find_backbone(network, p.species, {0, 1});
  const Stiffness stiffness(network, backbone, static_stress(network).trace() / 3);
  const Modes modes = find_modes(stiffness, CellFreedom::fixed, 6);
  ASSERT_FALSE(modes.unresisted.empty());
  Kick kick(p.size());
  kick.add(modes.unresisted.front(), backbone, p.radius);
  kick.give(p, 1e-4);
  const Vec3<double> along = network.contacts.front().normal;
  for (std::size_t k = 0; k < p.size(); ++k) {
    EXPECT_NEAR(norm(p.velocity[k]), 1e-4, 1e-13) << k;
    EXPECT_NEAR(dot(p.velocity[k], along), 0, 1e-13) << k;
    EXPECT_NEAR(norm(p.velocity[k] + p.velocity[(k + 1) % p.size()]), 0, 1e-13) << k;
  }
}

}  // namespace
}  // namespace furnas
