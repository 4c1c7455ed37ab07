#include "engine/analysis/force_distribution.h"

#include <gtest/gtest.h>

#include "engine/base/require.h"
#include "tests/engine/support/graph_packing.h"

namespace furnas {
namespace {

struct Pushed {
  double normal, tangential;
};

/// A ring of particles of one species; each contact has its forces, in directions that differ.
Packing ring_of(const std::vector<Pushed>& forces) {
  const auto count = static_cast<std::uint32_t>(forces.size());
  Packing p = packing_of_graph(count, chain(count) + Edges{{count - 1, 0}});
  for (std::size_t n = 0; n < count; ++n) {
    const auto& [normal, tangential] = forces[n];
    const bool even = n % 2 == 0;
    p.contacts[n].branch = even ? Vec3<double>{0.3, 0.4, 0} : Vec3<double>{0, 0, -0.9};
    const Vec3<double> direction = even ? Vec3<double>{0.6, 0.8, 0} : Vec3<double>{0, 0, -1};
    const Vec3<double> across = even ? Vec3<double>{0.8, -0.6, 0} : Vec3<double>{0, -1, 0};
    p.contacts[n].force = normal * direction + tangential * across;
  }
  return p;
}

std::vector<double> densities(const Histogram& h) {
  std::vector<double> all;
  for (std::size_t b = 0; b < h.bins(); ++b) all.push_back(h.density(b));
  return all;
}

TEST(ForceDistribution, IsMeasuredInMeans) {
  const Packing p = ring_of({{1, 0.3}, {2, 0.6}, {3.5, 1.3}, {5.5, 1.8}});
  const ForceDistribution normal = normal_forces(p, all_contacts(p), {.width = 0.5});
  EXPECT_EQ(normal.contacts, 4);
  EXPECT_DOUBLE_EQ(normal.mean, 3);
  EXPECT_DOUBLE_EQ(normal.largest, 5.5);
  // f/<f> is 0.33, 0.67, 1.17 and 1.83.
  EXPECT_EQ(normal.histogram.edges, (std::vector<double>{0, 0.5, 1, 1.5, 2}));
  EXPECT_EQ(densities(normal.histogram), (std::vector<double>{0.5, 0.5, 0.5, 0.5}));
  const ForceDistribution tangential = tangential_forces(p, all_contacts(p), {.width = 1});
  EXPECT_DOUBLE_EQ(tangential.mean, 1);
  EXPECT_EQ(densities(tangential.histogram), (std::vector<double>{0.5, 0.5}));
}

TEST(ForceDistribution, OfAKindIsMeasuredInItsOwnMean) {
  Packing p = ring_of({{1, 0}, {10, 0}, {3, 0}, {30, 0}});
  p.species = {Species::large, Species::large, Species::small, Species::small};
  // The kinds along the ring: large-large, large-small, small-small, large-small.
  const Selection mixed = of_kind(p, all_contacts(p), PairKind::large_small);
  EXPECT_EQ(mixed, (Selection{1, 3}));
  EXPECT_DOUBLE_EQ(normal_forces(p, mixed, {}).mean, 20);
  EXPECT_DOUBLE_EQ(normal_forces(p, of_kind(p, all_contacts(p), PairKind::small_small), {}).mean, 3);
  EXPECT_DOUBLE_EQ(normal_forces(p, all_contacts(p), {}).mean, 11);
}

TEST(ForceDistribution, LogarithmicBinsHoldAllForcesAboveZero) {
  const Packing p = ring_of({{1e-6, 0}, {2, 1}, {3, 0}, {60, 4}});
  const ForceDistribution normal = normal_forces(p, all_contacts(p), {.logarithmic = true, .per_decade = 5});
  EXPECT_EQ(normal.histogram.below + normal.histogram.above, 0);
  EXPECT_EQ(normal.histogram.values(), 4);
  const ForceDistribution tangential = tangential_forces(p, all_contacts(p), {.logarithmic = true});
  EXPECT_EQ(tangential.histogram.below, 2);
  EXPECT_EQ(tangential.histogram.values(), 4);
}

TEST(ForceDistribution, WithoutForcesHasNoBins) {
  const Packing p = ring_of({{1, 0}, {2, 0}});
  const ForceDistribution none = tangential_forces(p, all_contacts(p), {});
  EXPECT_EQ(none.contacts, 2);
  EXPECT_EQ(none.mean, 0);
  EXPECT_EQ(none.histogram.bins(), 0U);
  EXPECT_EQ(normal_forces(p, {}, {}).contacts, 0);
}

TEST(Mobilisation, IsTheShareOfTheCoulombLimit) {
  const Packing p = ring_of({{2, 0.3}, {4, 1.2}, {8, 4}, {-1, 1}, {1, 0}});
  const Mobilisation m = mobilisation(p, all_contacts(p), 0.5, 4);
  EXPECT_EQ(m.contacts, 4) << "a contact that pulls has no limit";
  // 0.3, 0.6, 1 and 0.
  EXPECT_EQ(m.histogram.counts, (std::vector<std::int64_t>{1, 1, 1, 1}));
  EXPECT_DOUBLE_EQ(m.mean, 1.9 / 4);
  EXPECT_EQ(m.sliding, 1);
  EXPECT_EQ(m.sliding_share(), 0.25);
  EXPECT_EQ(m.beyond, 0);
}

TEST(Mobilisation, TellsWhenTheFrictionIsNotThatOfThePacking) {
  const Packing p = ring_of({{2, 0.3}, {4, 1}, {8, 4}, {1, 0}});
  const Mobilisation m = mobilisation(p, all_contacts(p), 0.25, 4);
  // 0.6, 1, 2 and 0.
  EXPECT_EQ(m.sliding, 2);
  EXPECT_EQ(m.beyond, 1);
  EXPECT_EQ(m.histogram.above, 1);
  EXPECT_EQ(m.histogram.counts, (std::vector<std::int64_t>{1, 0, 1, 1}));
}

/// Forces that the law has scaled down to the limit are at it, however they were rounded.
TEST(Mobilisation, RoundingIsNoSliding) {
  for (const double off : {-1e-15, 1e-15, 3e-10}) {
    const Packing p = ring_of({{3, 0.9 * (1 + off)}, {1, 0}});
    const Mobilisation m = mobilisation(p, all_contacts(p), 0.3);
    EXPECT_EQ(m.sliding, 1) << off;
    EXPECT_EQ(m.beyond, 0) << off;
    EXPECT_EQ(m.histogram.counts.back(), 1) << off;
  }
  EXPECT_THROW(mobilisation(ring_of({{1, 0}, {1, 0}}), {0}, 0), ContractError);
}

}  // namespace
}  // namespace furnas
