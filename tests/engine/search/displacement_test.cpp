#include "engine/search/displacement.h"

#include <gtest/gtest.h>

#include <Eigen/SVD>

#include "engine/phases/barostat.h"
#include "engine/phases/renew_list.h"
#include "engine/trials/listed.h"
#include "tests/engine/support/brute_force.h"
#include "tests/engine/support/property.h"
#include "tests/engine/support/random_packing.h"

namespace furnas {
namespace {

using test::Dice;
using Smooth = Numerics<Frictionless<false>, double>;

/// A deformation near unity whose entries are of the size `strain`.
Triangle deformation(Dice& dice, double strain) {
  const auto entry = [&] { return dice.chance(0.3) ? 0 : dice.between(-strain, strain); };
  return {1 + entry(), 1 + entry(), 1 + entry(), entry(), entry(), entry()};
}

Eigen::Matrix3d dense(const Triangle& t) {
  Eigen::Matrix3d m;
  m << t.xx, t.xy, t.xz, 0, t.yy, t.yz, 0, 0, t.zz;
  return m;
}

/// Ways since the list was built, as the step measures them.
std::vector<double> measured(const Packing& p, const PairList& list) {
  std::vector<Particle<double, false>> particles;
  for (std::size_t k = 0; k < p.size(); ++k)
    particles.push_back({p.fraction[k], p.radius[k], p.velocity[k], 1 / p.mass[k]});
  ListDisplacement displacement;
  displacement.largest.resize(list.classes.size());
  constexpr double given_skin = 0;  // so that no list is too wide
  measure_displacement<Smooth>(given_skin, list.step, p.cell, list, particles, displacement);
  EXPECT_EQ(displacement.outdated,
            !list_is_complete(list, displacement.largest, shrinkage(list.edges, p.cell.edges)));
  return displacement.largest;
}

/// Whether a pair touches that no row means. Rows are named as they were when the list was built.
bool hides_a_touch(const Packing& then, const Packing& now, const PairList& list) {
  std::map<test::TouchName, bool> rows;
  for (const auto& [name, touch] : test::brute_pairs(then, 0)) rows[name];
  std::size_t covered = 0;
  const auto touches = test::brute_pairs(now, 0);
  for (std::uint32_t i = 0; i < now.size(); ++i)
    for (std::uint64_t k = list.first[i]; k < list.first[i + 1]; ++k) {
      const std::uint32_t j = list.partner[k];
      const Vec3<double> s = list.quarter.empty()
                                 ? nearest_difference(now.fraction[i], now.fraction[j])
                                 : row_difference(now.fraction[i], now.fraction[j], list.quarter[k]);
      covered += norm(now.cell.edges * s) < now.radius[i] + now.radius[j];
    }
  return covered != touches.size();
}

TEST(Shrinkage, IsTheLargestShareADistanceLoses) {
  EXPECT_TRUE(test::holds(1000, [] {
    Dice dice(test::any_seed());
    const Triangle then = test::random_edges(dice, dice.between(1, 100));
    const Triangle f = deformation(dice, std::pow(10.0, dice.between(-12, -0.4)));
    const Triangle now = product(f, then);
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(dense(f));
    RC_ASSERT(std::abs(shrinkage(then, now) - (1 - svd.singularValues()(2))) < 1e-13);
    RC_ASSERT(shrinkage_bound(then, now) >= shrinkage(then, now) - 1e-14);
  }));
  const Triangle h{3, 4, 5, 1, -1, 0.5};
  EXPECT_NEAR(shrinkage(h, h), 0, 1e-15);
  EXPECT_NEAR(shrinkage_bound(h, h), 0, 1e-15);
}

/// Two spheres just too far apart for a row, along the direction in which the cell will shrink most,
/// then moved towards each other by `share` of the way that would let them touch.
struct Approach {
  Packing then;
  Packing now;
  PairList list;
  bool alike;
};

Approach approach(Dice& dice, double share) {
  Approach a;
  Packing& p = a.then;
  p.cell.edges = test::random_edges(dice, 100);
  p.resize(2);
  p.mass = {1, 1};
  a.alike = dice.chance(0.5);
  p.radius = {0.5 * (a.alike ? 1 : dice.between(1, 10)), 0.5};
  const Skin skin{dice.chance(0.3) ? 0 : dice.between(0, 1), dice.chance(0.3) ? 0 : dice.between(0, 0.1)};
  const double radii = p.radius[0] + p.radius[1];
  const double reach = radii + skin(radii);
  const double strain = skin(radii) / reach * dice.between(0, 0.7);
  const Triangle f = deformation(dice, strain);
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(dense(f), Eigen::ComputeFullV);
  const Eigen::Vector3d weakest = svd.matrixV().col(2);
  const Vec3<double> direction{weakest.x(), weakest.y(), weakest.z()};
  const Triangle to_fraction_then = inverse(p.cell.edges);
  p.fraction[0] = {dice.word(), dice.word(), dice.word()};
  const auto shifted = [](const Fraction& s, const Vec3<double>& by) {
    const Fraction d = to_fraction(by);
    return Fraction{s.x + d.x, s.y + d.y, s.z + d.z};
  };
  p.fraction[1] = shifted(p.fraction[0], to_fraction_then * (reach * (1 + 1e-7) * direction));
  a.list = listed(p, skin);

  a.now = p;
  a.now.cell.edges = product(f, p.cell.edges);
  const Vec3<double> moved = f * direction;  // the pair's distance, shortened by the cell alone
  const double gap = norm(moved) * reach * (1 + 1e-7) - radii;
  const double part = a.alike ? 0.5 : dice.between(0, 1);
  const Vec3<double> move = (share * gap / norm(moved)) * moved;
  const Triangle to_fraction_now = inverse(a.now.cell.edges);
  a.now.fraction[0] = shifted(p.fraction[0], to_fraction_now * (part * move));
  a.now.fraction[1] = shifted(p.fraction[1], to_fraction_now * ((part - 1) * move));
  return a;
}

TEST(ListIsComplete, NeverWhileASkilfulPairTouchesUnlisted) {
  EXPECT_TRUE(test::holds(5000, [] {
    Dice dice(test::any_seed());
    const double share = dice.chance(0.5) ? 1 + std::pow(10.0, dice.between(-5, -1)) : dice.between(1.1, 1.5);
    const Approach a = approach(dice, share);
    RC_ASSERT(a.list.rows() == 0u);
    RC_ASSERT(hides_a_touch(a.then, a.now, a.list));
    RC_ASSERT(
        !list_is_complete(a.list, measured(a.now, a.list), shrinkage(a.then.cell.edges, a.now.cell.edges)));
  }));
}

// The bound wastes nothing: two equal spheres that come half the way each use up all of it.
TEST(ListIsComplete, AsLongAsEqualSpheresHaveNotMet) {
  EXPECT_TRUE(test::holds(2000, [] {
    Dice dice(test::any_seed());
    const Approach a = approach(dice, dice.between(0, 0.9));
    if (!a.alike || a.list.skin(1) < 1e-3) return;
    RC_ASSERT(
        list_is_complete(a.list, measured(a.now, a.list), shrinkage(a.then.cell.edges, a.now.cell.edges)));
  }));
}

/// Many spheres, any cell, images included.
TEST(ListIsComplete, NeverWhileAnyPairTouchesUnlisted) {
  EXPECT_TRUE(test::holds(3000, [] {
    Dice dice(test::any_seed());
    test::RandomPacking wanted;
    wanted.size_ratio = *rc::gen::element(1, 3, 10);
    wanted.large = *rc::gen::inRange<std::size_t>(0, 3);
    wanted.small = *rc::gen::inRange<std::size_t>(1, 30);
    wanted.cell = (wanted.large > 0 ? wanted.size_ratio : 1) * dice.between(0.7, 4);
    wanted.spread = dice.chance(0.5) ? 0 : 0.6;
    const Packing then = in_memory_order(test::random_packing(dice, wanted));
    const Skin skin{dice.between(0, 0.3), dice.between(0, 0.1)};
    const PairList list = listed(then, skin);
    Packing now = then;
    now.cell.edges = product(deformation(dice, dice.between(0, 0.1)), then.cell.edges);
    const double size = std::pow(10.0, dice.between(-3, -0.5));
    for (Fraction& s : now.fraction) {
      const Fraction moved = to_fraction(inverse(now.cell.edges) * dice.vector(size));
      s = {s.x + moved.x, s.y + moved.y, s.z + moved.z};
    }
    if (list_is_complete(list, measured(now, list), shrinkage(then.cell.edges, now.cell.edges)))
      RC_ASSERT(!hides_a_touch(then, now, list));
  }));
}

// What is watched in every step bounds what is measured, however cell and particles have moved.
TEST(AddDisplacement, SuspectsEveryListThatIsWorn) {
  EXPECT_TRUE(test::holds(1000, [] {
    Dice dice(test::any_seed());
    test::RandomPacking wanted;
    wanted.size_ratio = 3;
    wanted.large = 1;
    wanted.small = 3;
    wanted.cell = 12;
    Packing p = in_memory_order(test::random_packing(dice, wanted));
    const PairList list = listed(p, {dice.between(0, 1.5), dice.between(0, 0.1)});
    // A cell that stretches along the way the particles went carries them further than they went.
    const double a = dice.between(0, 0.3);
    const Triangle carried = dice.chance(0.5) ? Triangle{1 + a, 1 - a, 1} : deformation(dice, 0.3);
    const Triangle rates[] = {dice.chance(0.5) ? Triangle{1, 1, 1} : deformation(dice, 0.3), carried};
    const double dt = dice.between(0.001, 0.1);
    const double fast = dice.between(0, 3);
    ListDisplacement displacement;
    displacement.largest.assign(list.classes.size(), 0);
    const std::uint64_t turn = 1 + dice.below(20);
    for (std::uint64_t step = 0; step < 40; ++step) {
      const Triangle& rate = rates[step < turn ? 0 : 1];
      p.cell.rate = {rate.xx - 1, rate.yy - 1, rate.zz - 1, rate.yz, rate.xz, rate.xy};
      stretch_cell(Barostat{}, dt, p.cell);
      const double speed = step < turn ? fast : 0;
      SquaredDisplacement longest(list.classes.size(), 0);
      for (std::size_t c = 0; c < list.classes.size(); ++c)
        for (std::size_t k = list.classes[c].first; k < list.classes[c].last; ++k) {
          const Vec3<double> s = inverse(p.cell.edges) * Vec3<double>{dt * speed, 0, 0};
          const Fraction moved = to_fraction(s);
          p.fraction[k] = {p.fraction[k].x + moved.x, p.fraction[k].y + moved.y, p.fraction[k].z + moved.z};
          longest[c] = std::max(longest[c], dot(list.edges * s, list.edges * s));
        }
      stretch_cell(Barostat{}, dt, p.cell);
      add_displacement(list.step, longest, p.cell, list, displacement);
      if (displacement.suspect) return;
      RC_ASSERT(list_is_complete(list, measured(p, list), shrinkage(list.edges, p.cell.edges)));
    }
  }));
}

}  // namespace
}  // namespace furnas
