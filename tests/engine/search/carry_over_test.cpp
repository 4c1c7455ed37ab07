#include "engine/search/carry_over.h"

#include <gtest/gtest.h>

#include "engine/trials/listed.h"
#include "tests/engine/support/brute_force.h"
#include "tests/engine/support/property.h"
#include "tests/engine/support/random_packing.h"
#include "tests/engine/support/same_packing.h"

namespace furnas {
namespace {

using test::Dice;
using test::TouchName;

/// What a row that meant `then` means after its particles have moved by these fractions.
TouchName name_after(const Packing& now, std::uint32_t i, std::uint32_t j, const Vec3<double>& then,
                     const Vec3<double>& move_i, const Vec3<double>& move_j) {
  const Vec3<double> cells = then + move_i - move_j - nearest_difference(now.fraction[i], now.fraction[j]);
  const auto whole = [](double x) { return static_cast<std::int8_t>(std::nearbyint(x)); };
  Contact c;
  c.i = i;
  c.j = j;
  c.image = {whole(cells.x), whole(cells.y), whole(cells.z)};
  return test::name_of(now, c);
}

// Old rows and new ones, each image of a pair apart, across faces and with another skin.
TEST(CarryOver, StaysWithThePairAndItsImage) {
  EXPECT_TRUE(test::holds(2000, [] {
    Dice dice(test::any_seed());
    test::RandomPacking wanted;
    wanted.size_ratio = *rc::gen::element(1, 2, 7);
    wanted.large = *rc::gen::inRange<std::size_t>(0, 3);
    wanted.small = *rc::gen::inRange<std::size_t>(1, 20);
    wanted.cell = (wanted.large > 0 ? wanted.size_ratio : 1) * dice.between(0.5, 4);
    const Packing then = in_memory_order(test::random_packing(dice, wanted));
    const PairList old = listed(then, {dice.between(0, 0.5), 0});
    ContactState<double> contact_state;
    contact_state.clear(old.rows(), old.first.size() - 1, true);
    for (std::size_t k = 0; k < old.rows(); ++k)
      if (dice.chance(0.7)) contact_state.touching[k] = 1, contact_state.springs[k].history = dice.vector(1);

    Packing now = then;
    now.cell.edges = product({1.02, 0.98, 1, 0.01, 0, -0.02}, then.cell.edges);
    std::vector<Vec3<double>> move(now.size());
    for (std::size_t k = 0; k < now.size(); ++k) {
      move[k] = dice.vector(old.quarter.empty() ? 0.02 : 0.12);
      const Fraction m = to_fraction(move[k]);
      now.fraction[k] = {then.fraction[k].x + m.x, then.fraction[k].y + m.y, then.fraction[k].z + m.z};
    }

    std::map<TouchName, Vec3<double>> expected;
    std::set<TouchName> names;
    for (std::uint32_t i = 0; i < then.size(); ++i)
      for (std::uint64_t k = old.first[i]; k < old.first[i + 1]; ++k) {
        const std::uint32_t j = old.partner[k];
        const Vec3<double> d = old.quarter.empty()
                                   ? nearest_difference(then.fraction[i], then.fraction[j])
                                   : row_difference(then.fraction[i], then.fraction[j], old.quarter[k]);
        const TouchName name = name_after(now, i, j, d, move[i], move[j]);
        RC_ASSERT(names.insert(name).second);
        if (contact_state.touching[k] != 0) expected[name] = contact_state.springs[k].history;
      }

    const PairList fresh = listed(now, {dice.between(0, 0.5), 0});
    enter_contacts(contacts_of_rows(old, contact_state, now.fraction), fresh, now.fraction, true,
                   contact_state);
    RC_ASSERT(contact_state.springs.size() == fresh.rows() && contact_state.touching.size() == fresh.rows());
    std::vector<std::uint32_t> contacts(now.size());
    for (std::uint32_t i = 0; i < now.size(); ++i)
      for (std::uint64_t k = fresh.first[i]; k < fresh.first[i + 1]; ++k) {
        const std::uint32_t j = fresh.partner[k];
        if (contact_state.touching[k] != 0) ++contacts[i], ++contacts[j];
        Contact c;
        c.i = i;
        c.j = j;
        c.image = image_of_row(fresh, k, now.fraction[i], now.fraction[j]);
        const auto found = expected.find(test::name_of(now, c));
        const Vec3<double> wanted_history = found == expected.end() ? Vec3<double>{} : found->second;
        RC_ASSERT(test::same_bits(contact_state.springs[k].history, wanted_history));
        RC_ASSERT((contact_state.touching[k] != 0) == (found != expected.end()));
      }
    RC_ASSERT(std::equal(contacts.begin(), contacts.end(), contact_state.contacts.begin(),
                         contact_state.contacts.end()));
  }));
}

TEST(CarryOver, IsEmptyWhenThereWasNoList) {
  Packing p;
  p.resize(2);
  p.radius = {0.5, 0.5};
  p.cell.edges = {5, 5, 5};
  p.fraction[1] = to_fraction({0.1, 0, 0});
  const PairList fresh = listed(p, {0, 0});
  ContactState<double> contact_state;
  enter_contacts(contacts_of_rows({}, contact_state, p.fraction), fresh, p.fraction, true, contact_state);
  ASSERT_EQ(contact_state.springs.size(), 1u);
  EXPECT_EQ(contact_state.springs[0].history, Vec3<double>{});
  EXPECT_EQ(contact_state.touching, std::vector<std::uint8_t>(1));
}

}  // namespace
}  // namespace furnas
