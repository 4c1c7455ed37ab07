#include "engine/analysis/coordination.h"

#include <gtest/gtest.h>

#include "engine/analysis/rattlers.h"
#include "tests/engine/support/graph_packing.h"

namespace furnas {
namespace {

/// Two large ones (0, 1) and three small ones (2, 3, 4): one large-large contact, three large-small, two
/// small-small.
Packing five() {
  Packing p = packing_of_graph(5, {{0, 1}, {0, 2}, {0, 3}, {4, 1}, {2, 3}, {3, 4}});
  for (const std::size_t k : {2, 3, 4}) p.species[k] = Species::small;
  return p;
}

TEST(Coordination, CountsContactsOfEachKindAndPerParticle) {
  const Coordination c = coordination(five());
  EXPECT_EQ(c.large, 2);
  EXPECT_EQ(c.small, 3);
  EXPECT_EQ(c.contacts, (std::array<std::int64_t, 3>{1, 3, 2}));
  EXPECT_EQ(c.mean(), 12.0 / 5);
  EXPECT_EQ(c.of(Species::large, Species::large), 1);
  EXPECT_EQ(c.of(Species::large, Species::small), 1.5);
  EXPECT_EQ(c.of(Species::small, Species::large), 1);
  EXPECT_EQ(c.of(Species::small, Species::small), 4.0 / 3);
  // Every contact has two ends.
  EXPECT_DOUBLE_EQ(2 * c.of(Species::large) + 3 * c.of(Species::small), 2.0 * 6);
}

TEST(Coordination, OfTheBackboneLeavesRattlersAndFaintContactsOut) {
  Packing p = five();
  p.contacts[4].force = {1e-3, 0, 0};  // small-small, below 1 % of the mean of its kind
  p.contacts.push_back(p.contacts[4]);
  p.contacts.back().i = 0, p.contacts.back().j = 4;  // as faint, between two of the backbone
  const std::vector<bool> live = live_contacts(p), rattler = rattlers(p, live, 2);
  // 2 hangs by one live contact; 0-1-4-3 is a ring.
  EXPECT_EQ(rattler, (std::vector<bool>{false, false, true, false, false}));
  const Selection backbone = backbone_contacts(p, live, rattler);
  EXPECT_EQ(backbone, (Selection{0, 2, 3, 5}));
  const Coordination c = coordination(p, rattler, backbone);
  EXPECT_EQ(c.large, 2);
  EXPECT_EQ(c.small, 2);
  EXPECT_EQ(c.contacts, (std::array<std::int64_t, 3>{1, 2, 1}));
  EXPECT_EQ(c.mean(), 2);
  EXPECT_EQ(of_kind(p, backbone, PairKind::large_small), (Selection{2, 3}));
}

TEST(Coordination, OfNothingIsZero) {
  const Coordination c = coordination(packing_of_graph(0, {}));
  EXPECT_EQ(c.mean(), 0);
  EXPECT_EQ(c.of(Species::small), 0);
}

}  // namespace
}  // namespace furnas
