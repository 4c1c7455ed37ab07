#include <gtest/gtest.h>

#include "engine/simulation.h"
#include "tests/engine/support/brute_force.h"
#include "tests/engine/support/property.h"
#include "tests/engine/support/random_packing.h"

namespace furnas {
namespace {

using test::Dice;
using test::Far;
using test::Long;

constexpr double tolerance = 1e-13;

Model random_model(Dice& dice) {
  Model model;
  HookeConstants constants;
  constants.friction = dice.chance(0.3) ? 0 : dice.between(0, 1);
  if (constants.friction == 0)
    model.law = Frictionless<false>{constants};
  else
    model.law = HookeSynchronized{constants};
  if (dice.chance(0.8)) model.skin = dice.chance(0.3) ? 0 : dice.between(0, 0.5);
  return model;
}

bool near(const Vec3<double>& a, const Far& b, Long scale) {
  return norm(Far{a.x - b.x, a.y - b.y, a.z - b.z}) <= Long(tolerance) * scale;
}

/// Sums of the brute force over the contacts, and how large their terms are.
struct Sums {
  explicit Sums(std::size_t n) : force(n), torque(n), scale(n) {}

  void add(const Packing& p, const test::TouchName& name, const test::BruteTouch& touch, const Far& f,
           Long size) {
    const Long half_overlap = (Long(p.radius[name.i]) + Long(p.radius[name.j]) - touch.distance) / 2;
    const Far couple = cross(touch.branch * (1 / touch.distance), f);
    force[name.i] += f;
    force[name.j] -= f;
    torque[name.i] -= (Long(p.radius[name.i]) - half_overlap) * couple;
    torque[name.j] -= (Long(p.radius[name.j]) - half_overlap) * couple;
    scale[name.i] += size;
    scale[name.j] += size;
    stress[0] += touch.branch.x * f, stress[1] += touch.branch.y * f, stress[2] += touch.branch.z * f;
    stress_scale += touch.distance * size;
  }

  std::vector<Far> force, torque;
  std::array<Far, 3> stress{};
  std::vector<Long> scale;
  Long stress_scale{};
};

/// The engine's contacts, forces and stress against all pairs and all images.
void compare_with_brute_force(const Model& model, const Packing& start) {
  const Packing p = make_simulation(model, start)->packing();
  const bool spins = std::holds_alternative<HookeSynchronized>(model.law);
  const HookeConstants law = spins ? std::get<HookeSynchronized>(model.law).constants
                                   : std::get<Frictionless<false>>(model.law).constants;

  const auto expected = test::brute_pairs(p, 0);
  std::map<test::TouchName, Contact> found;
  for (const Contact& c : p.contacts) RC_ASSERT(found.emplace(test::name_of(p, c), c).second);

  Sums sums(p.size());
  for (const auto& [name, touch] : expected) {
    const Long reach = Long(p.radius[name.i]) + Long(p.radius[name.j]);
    const Far f = test::brute_force(p, law, spins, name, touch);
    if (!found.contains(name)) {
      RC_ASSERT(reach - touch.distance <= 1e-14L * reach);  // touch of points, open to rounding
      continue;
    }
    const Contact c = found.at(name);
    found.erase(name);
    const bool same_way =
        c.i == name.i && c.image == std::array<std::int8_t, 3>{static_cast<std::int8_t>(name.image[0]),
                                                               static_cast<std::int8_t>(name.image[1]),
                                                               static_cast<std::int8_t>(name.image[2])};
    const double sign = same_way ? 1 : -1;
    // An overlap is a difference of lengths: it is known to the rounding of those.
    const Long size = norm(f) + reach;
    RC_ASSERT(near(sign * c.branch, touch.branch, reach));
    RC_ASSERT(std::abs(c.overlap - (reach - touch.distance)) <= tolerance * reach);
    RC_ASSERT(near(sign * c.force, f, size));
    sums.add(p, name, touch, f, size);
  }
  for (const auto& [name, c] : found) RC_ASSERT(c.overlap <= 1e-14 * (p.radius[c.i] + p.radius[c.j]));
  for (std::size_t k = 0; k < p.size(); ++k) {
    RC_ASSERT(near(p.force[k], sums.force[k], sums.scale[k]));
    RC_ASSERT(near(p.torque[k], spins ? sums.torque[k] : Far{}, p.radius[k] * sums.scale[k]));
  }
  for (int a = 0; a < 3; ++a) {
    const Vec3<double> row{p.stress.contacts(a, 0), p.stress.contacts(a, 1), p.stress.contacts(a, 2)};
    RC_ASSERT(near(row, sums.stress[static_cast<std::size_t>(a)], sums.stress_scale));
  }
}

TEST(Contacts, EqualBruteForceInAnyCell) {
  EXPECT_TRUE(test::holds(3000, [] {
    Dice dice(test::any_seed());
    test::RandomPacking wanted;
    wanted.size_ratio = *rc::gen::element(1, 2, 3, 10, 40);
    wanted.large = *rc::gen::inRange<std::size_t>(0, 4);
    wanted.small = *rc::gen::inRange<std::size_t>(1, 40);
    wanted.cell = (wanted.large > 0 ? wanted.size_ratio : 1) * dice.between(2.5, 5);
    wanted.spread = dice.chance(0.5) ? 0 : 0.6;
    compare_with_brute_force(random_model(dice), test::random_packing(dice, wanted));
  }));
}

// Smaller than two reaches: a pair meets several times, a sphere meets its own images.
TEST(Contacts, EqualBruteForceInCellsSmallerThanASphere) {
  EXPECT_TRUE(test::holds(3000, [] {
    Dice dice(test::any_seed());
    test::RandomPacking wanted;
    wanted.size_ratio = *rc::gen::element(1, 2, 5, 40);
    wanted.large = *rc::gen::inRange<std::size_t>(0, 3);
    wanted.small = *rc::gen::inRange<std::size_t>(0, 6);
    if (wanted.large + wanted.small == 0) wanted.large = 1;
    wanted.cell = (wanted.large > 0 ? wanted.size_ratio : 1) * dice.between(0.35, 2.5);
    compare_with_brute_force(random_model(dice), test::random_packing(dice, wanted));
  }));
}

// Crystals: centres exactly on faces, edges and halves of the cell, spheres that just touch or just not.
TEST(Contacts, EqualBruteForceInCrystals) {
  for (int cells : {1, 2, 3, 5})
    for (double spacing : {1.0, 1 - 0x1p-53, 1 - 0x1p-40, 1 + 0x1p-40, 0.75, 0.5})
      for (std::uint64_t shift : {0ull, 1ull, ~0ull, 1ull << 63, 12345678901234567ull}) {
        Packing p;
        p.cell.edges = {spacing * cells, spacing * cells, spacing * cells};
        for (int x = 0; x < cells; ++x)
          for (int y = 0; y < cells; ++y)
            for (int z = 0; z < cells; ++z) {
              const auto at = [&](int n) { return to_fixed(static_cast<double>(n) / cells) + shift; };
              p.fraction.push_back({at(x), at(y), at(z)});
            }
        const auto fraction = p.fraction;
        p.resize(fraction.size());
        p.radius.assign(p.size(), 0.5);
        p.mass.assign(p.size(), 1);
        for (double skin : {0.0, 0.1}) {
          Model model;
          model.law = Frictionless<false>{};
          model.skin = skin;
          EXPECT_TRUE(test::holds(1, [&] { compare_with_brute_force(model, p); }))
              << cells << " cells, spacing " << spacing << ", shift " << shift << ", skin " << skin;
        }
      }
}

}  // namespace
}  // namespace furnas
