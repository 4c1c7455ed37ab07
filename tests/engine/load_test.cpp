#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "engine/base/require.h"
#include "engine/search/size_classes.h"
#include "tests/engine/support/brute_force.h"
#include "tests/engine/support/compaction.h"
#include "tests/engine/support/property.h"
#include "tests/engine/support/random_packing.h"
#include "tests/engine/support/same_packing.h"

namespace furnas {
namespace {

using test::Dice;
using test::TouchName;

/// Force and history of each contact, seen from the particle that its name puts first.
std::map<TouchName, std::array<Vec3<double>, 2>> contacts_by_name(const Packing& p) {
  std::map<TouchName, std::array<Vec3<double>, 2>> contacts;
  for (const Contact& c : p.contacts) {
    const TouchName name = test::name_of(p, c);
    const double sign = name == TouchName{c.i, c.j, {c.image[0], c.image[1], c.image[2]}} ? 1 : -1;
    contacts[name] = {sign * c.force, sign * c.history};
  }
  return contacts;
}

/// The contact as seen from the other particle.
Contact mirrored(const Packing& p, Contact c) {
  const Contact was = c;
  std::swap(c.i, c.j);
  constexpr std::uint64_t half = std::uint64_t{1} << 63;
  const Fraction &a = p.fraction[was.i], &b = p.fraction[was.j];
  // A difference of half a cell is its own opposite, so its image moves by one.
  c.image = {static_cast<std::int8_t>((a.x - b.x == half) - was.image[0]),
             static_cast<std::int8_t>((a.y - b.y == half) - was.image[1]),
             static_cast<std::int8_t>((a.z - b.z == half) - was.image[2])};
  c.branch = -c.branch;
  c.force = -c.force;
  c.history = -c.history;
  return c;
}

/// Any order that keeps the size classes together.
std::vector<std::uint32_t> shuffled_order(Dice& dice, const Packing& p) {
  std::vector<std::pair<double, std::uint64_t>> key(p.size());
  for (std::size_t k = 0; k < p.size(); ++k) key[k] = {-p.radius[k], dice.word()};
  std::vector<std::uint32_t> order(p.size());
  for (std::uint32_t k = 0; k < order.size(); ++k) order[k] = k;
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return key[a] < key[b]; });
  return order;
}

/// A packing with histories: a crowded one after a few steps.
Packing used_packing(Dice& dice, const Model& model) {
  test::RandomPacking wanted;
  wanted.size_ratio = *rc::gen::element(1, 3);
  wanted.large = *rc::gen::inRange<std::size_t>(1, 4);
  wanted.small = *rc::gen::inRange<std::size_t>(0, 30);
  wanted.cell = wanted.size_ratio * dice.between(0.8, 4);
  const auto simulation = make_simulation(model, test::random_packing(dice, wanted));
  simulation->advance(20);
  return simulation->packing();
}

TEST(Load, KeepsEveryHistoryInAnotherOrder) {
  EXPECT_TRUE(test::holds(300, [] {
    Dice dice(test::any_seed());
    const Model model = test::hasty_model(0.3);
    const Packing before = used_packing(dice, model);
    Packing shuffled = before;
    shuffled.order = shuffled_order(dice, before);
    std::shuffle(shuffled.contacts.begin(), shuffled.contacts.end(), std::minstd_rand(1));
    const Packing after = make_simulation(model, shuffled)->packing();
    RC_ASSERT(after.order == shuffled.order);
    RC_ASSERT(contacts_by_name(after) == contacts_by_name(before));
  }));
}

TEST(Load, TakesContactsFromEitherSide) {
  EXPECT_TRUE(test::holds(300, [] {
    Dice dice(test::any_seed());
    const Model model = test::hasty_model(0.3);
    const Packing before = used_packing(dice, model);
    Packing other = before;
    for (Contact& c : other.contacts)
      if (dice.chance(0.5)) c = mirrored(before, c);
    RC_ASSERT(bool(test::same_packing(make_simulation(model, other)->packing(), before)));
  }));
}

// Half a cell apart, both images at the same distance: whose is whose shows only in the image.
TEST(Load, TakesContactsFromEitherSideOfACrystal) {
  Packing start;
  start.resize(8);
  start.radius.assign(8, 0.5);
  start.mass.assign(8, 0.5236);
  start.cell.edges = {1.9, 1.9, 1.9};
  for (std::uint64_t k = 0; k < 8; ++k) {
    start.fraction[k] = {(k & 1) << 63, (k >> 1 & 1) << 63, (k >> 2) << 63};
    start.spin[k] = {0.01 * static_cast<double>(k), -0.02, 0.03};
  }
  const Model model = test::hasty_model(0.3);
  const auto simulation = make_simulation(model, start);
  Packing before = simulation->packing();
  ASSERT_EQ(before.contacts.size(), 24u);
  for (std::size_t k = 0; k < before.contacts.size(); ++k)
    before.contacts[k].history = {0, static_cast<double>(k) * 1e-3, 0};
  Packing other = before;
  for (Contact& c : other.contacts) c = mirrored(before, c);
  simulation->load(other);
  EXPECT_EQ(contacts_by_name(simulation->packing()), contacts_by_name(before));
  other = before;
  std::reverse(other.order.begin(), other.order.end());
  simulation->load(other);
  EXPECT_EQ(contacts_by_name(simulation->packing()), contacts_by_name(before));
}

TEST(Load, RefusesAnOrderThatIsNone) {
  const Model model = test::hasty_model(0);
  Packing p = make_simulation(model, test::hasty_gas(2))->packing();
  const std::vector<std::uint32_t> order = p.order;
  p.order.back() = p.order.front();
  EXPECT_THROW(make_simulation(model, p), InputError) << "a particle twice, another never";
  p.order = order;
  p.order.back() = 1 << 30;
  EXPECT_THROW(make_simulation(model, p), InputError) << "a particle that is not there";
  p.order = order;
  std::reverse(p.order.begin(), p.order.end());
  EXPECT_THROW(make_simulation(model, p), InputError) << "small ones before large ones";
  p.order = order;
  p.order.pop_back();
  EXPECT_THROW(make_simulation(model, p), InputError) << "one short";
}

TEST(Load, RefusesContactsThatCannotBe) {
  const Model model = test::hasty_model(0.3);
  const auto simulation = make_simulation(model, test::hasty_gas(2));
  simulation->advance(400);
  const Packing good = simulation->packing();
  ASSERT_FALSE(good.contacts.empty());
  Packing p = good;
  p.contacts.front().j = 1 << 30;
  EXPECT_THROW(make_simulation(model, p), InputError) << "a partner that is not there";
  p = good;
  p.contacts.front().image = {5, 0, 0};
  EXPECT_THROW(make_simulation(model, p), InputError) << "an image out of reach";
}

}  // namespace
}  // namespace furnas
