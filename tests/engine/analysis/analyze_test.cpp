#include "engine/analysis/analyze.h"

#include <gtest/gtest.h>

#include "engine/monitor/measure.h"
#include "engine/trials/crystal.h"
#include "tests/engine/support/setups.h"

namespace furnas {
namespace {

TEST(Analyze, AgreesWithTheMeasuresOfARun) {
  const Packing& p = jammed();
  const Measures m = measure(p, 3);
  const Analysis a = analyze(p, {.friction = 0.3, .backbone_threshold = 3});
  ASSERT_TRUE(a.network);
  EXPECT_EQ(a.phi, m.phi);
  EXPECT_DOUBLE_EQ(a.network->coordination.mean(), m.coordination);
  EXPECT_EQ(a.network->rattlers.size(), 12U);
  for (const auto& [share, count] : a.network->rattlers) {
    if (share != live_force_share) continue;
    const RattlerCount& same = m.rattlers[static_cast<std::size_t>(count.least_contacts - 2)];
    EXPECT_EQ(count.large, same.large);
    EXPECT_EQ(count.small, same.small);
    EXPECT_EQ(count.contacts, same.contacts);
  }
  const Coordination& backbone = a.network->backbone_coordination;
  EXPECT_GT(backbone.particles(), 30) << "or the test says little";
  EXPECT_EQ(backbone.particles(), m.rattlers[1].backbone);
  EXPECT_EQ(backbone.all_contacts(), m.rattlers[1].contacts);
  EXPECT_DOUBLE_EQ(backbone.mean(), m.rattlers[1].coordination);
}

TEST(Analyze, KindsAddUpToAll) {
  const Analysis a = analyze(jammed(), {.friction = 0.3, .backbone_threshold = 3});
  const auto& backbone = a.network->backbone;
  ASSERT_GT(backbone.size(), 2U);
  EXPECT_FALSE(backbone[0].kind);
  std::int64_t contacts = 0, sliding = 0;
  double force = 0, xx = 0;
  for (std::size_t k = 1; k < backbone.size(); ++k) {
    ASSERT_TRUE(backbone[k].kind);
    EXPECT_EQ(backbone[k].normal.contacts,
              a.network->backbone_coordination.contacts[static_cast<std::size_t>(*backbone[k].kind)]);
    contacts += backbone[k].normal.contacts;
    sliding += backbone[k].mobilisation->sliding;
    force += backbone[k].normal.mean * static_cast<double>(backbone[k].normal.contacts);
    xx += backbone[k].fabric.tensor[0] * static_cast<double>(backbone[k].fabric.contacts);
  }
  const auto all = static_cast<double>(backbone[0].normal.contacts);
  EXPECT_EQ(contacts, backbone[0].normal.contacts);
  EXPECT_EQ(sliding, backbone[0].mobilisation->sliding);
  EXPECT_NEAR(force, backbone[0].normal.mean * all, 1e-12 * force);
  EXPECT_NEAR(xx, backbone[0].fabric.tensor[0] * all, 1e-12 * all);
  EXPECT_EQ(backbone[0].mobilisation->beyond, 0) << "the law keeps to Coulomb's limit";
}

/// phi_L and phi_S say the same as phi and f_s: the large spheres fill phi_L, the small ones phi_S of the
/// rest.
TEST(Analyze, ThePartsFillTheWhole) {
  std::vector<Ball> balls{{.position = {2, 2, 2}, .radius = 2}};
  for (int n = 0; n < 5; ++n) balls.push_back({.position = {7, 1.5 * n, 7}});
  const Analysis a = analyze(packing_of(cube(10), balls), {});
  EXPECT_EQ(a.large, 1);
  EXPECT_EQ(a.small, 5);
  ASSERT_TRUE(a.mixture);
  const auto& [small_fraction, phi_large, phi_small] = *a.mixture;
  EXPECT_DOUBLE_EQ(phi_large, mass_of(2) / 1000);
  EXPECT_DOUBLE_EQ(phi_small, 5 * mass_of(0.5) / (1000 - mass_of(2)));
  EXPECT_DOUBLE_EQ(small_fraction, 5 * mass_of(0.5) / (mass_of(2) + 5 * mass_of(0.5)));
  EXPECT_DOUBLE_EQ(phi_large + phi_small * (1 - phi_large), a.phi);
  EXPECT_FALSE(a.network) << "nothing touches";
}

TEST(Analyze, OfOneSizeHasNoSmallOnes) {
  const Packing p = with_forces(model_of<HookeSynchronized>({}), simple_cubic(0.95, 4));
  const Analysis a = analyze(p, {.backbone_threshold = 4});
  // All are small by their radius of 1/2 alone; what a start of one size calls large is not asked here.
  EXPECT_EQ(a.small + a.large, 64);
  ASSERT_TRUE(a.network);
  EXPECT_EQ(a.network->coordination.mean(), 6);
  EXPECT_EQ(a.network->backbone.size(), 2U) << "all, and the one kind";
  EXPECT_NEAR(a.network->backbone[0].normal.mean, 0.05, 1e-14);
  EXPECT_FALSE(a.network->backbone[0].mobilisation) << "without friction there is no limit";
  EXPECT_EQ(a.pairs.size(), 1U);
}

/// Of 64 spheres of 64 sizes none is the large one.
TEST(Analyze, OfManySizesHasNoSpecies) {
  Packing p = simple_cubic(0.95, 4);
  for (std::size_t k = 0; k < p.size(); ++k) p.radius[k] = 0.5 * (1 + 1e-3 * static_cast<double>(k));
  p.species = species_by_size(p.radius);
  const Analysis a = analyze(with_forces(model_of<HookeSynchronized>({}), p), {.backbone_threshold = 4});
  EXPECT_TRUE(a.polydisperse);
  EXPECT_FALSE(a.has_species());
  EXPECT_FALSE(a.mixture);
  EXPECT_EQ(a.sizes.count, 64U);
  EXPECT_DOUBLE_EQ(a.sizes.largest, 1.063);
  EXPECT_EQ(a.network->coordination.mean(), 6);
  EXPECT_EQ(a.network->backbone.size(), 1U) << "all, and no kind";
  ASSERT_EQ(a.pairs.size(), 1U);
  EXPECT_FALSE(a.pairs[0].kind);
  EXPECT_GT(a.phi, 0.5);
}

}  // namespace
}  // namespace furnas
