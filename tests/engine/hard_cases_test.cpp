#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "engine/base/require.h"
#include "tests/engine/laws/every_law.h"
#include "tests/engine/support/brute_force.h"
#include "tests/engine/support/dice.h"
#include "tests/engine/support/setups.h"

namespace furnas {
namespace {

bool finite(const Packing& p) {
  double sum = 0;
  for (std::size_t k = 0; k < p.size(); ++k)
    sum += norm(p.velocity[k]) + norm(p.spin[k]) + norm(p.force[k]) + norm(p.torque[k]);
  for (const Contact& c : p.contacts) sum += norm(c.force) + norm(c.history);
  return std::isfinite(sum + p.stress.total().norm());
}

template <class Law>
class HardCase : public testing::Test {};
TYPED_TEST_SUITE(HardCase, EveryLaw, LawName);

template <class Law>
Model hard_model(double time_step = paper_step) {
  return model_of<Law>({.friction = 0.5}, time_step);
}

// T61: a start with common centres is refused and names the particles by their ids.
TYPED_TEST(HardCase, StartWithCommonCentresIsRefusedWithIds) {
  const Packing p = packing_of(
      cube(16), {{.position = {1, 1, 1}}, {.position = {4, 5, 6}}, {.position = {4, 5, 6}, .radius = 2}});
  try {
    make_simulation(hard_model<TypeParam>(), p);
    FAIL() << "two spheres with one centre were accepted";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("2 and particle 3"), std::string::npos) << error.what();
  }
}

// T61: overlaps of 90 % of a radius, a small sphere inside a large one, centres 2^-60 of the cell apart: the
// forces are finite, they repel with k overlap, and the spheres part.
TYPED_TEST(HardCase, ExtremeOverlapsRepel) {
  for (const auto& [radius, distance] : {std::pair{0.5, 0.55}, {20.0, 3.0}, {0.5, 16 * std::pow(2.0, -60)}}) {
    const Packing start = packing_of(
        cube(128), {{.position = {64 + distance, 64, 64}}, {.position = {64, 64, 64}, .radius = radius}});
    Packing exact = start;
    if (distance < 1e-12) {
      exact.fraction[0] = exact.fraction[1];
      exact.fraction[0].x += 16;
    }
    const auto simulation = make_simulation(hard_model<TypeParam>(), exact);
    const Packing first = simulation->packing();
    EXPECT_NEAR(first.force[0].x, 0.5 + radius - distance, 1e-12);
    EXPECT_EQ(first.force[1], -first.force[0]);
    for (int n = 0; n < 100; ++n) {
      simulation->advance(1);
      ASSERT_TRUE(finite(simulation->packing())) << n;
    }
    EXPECT_GT(simulation->packing().velocity[0].x, 0);
  }
}

// T61: centres that come to lie on each other in a step, and centres that swap sides in one, through the
// common centre or just beside it: never a number that is none.
TYPED_TEST(HardCase, FlyingThroughEachOtherStaysFinite) {
  const double step = 1.0 / 32;
  for (double gap : {1.5, 0.5})
    for (double ways : {1.0, 2.0, 1.5, 0.75})
      for (double aside : {0.0, 1e-12, 1e-3}) {
        const Packing start = packing_of(cube(64), {{.position = {32 + gap, 32 + aside, 32},
                                                     .velocity = {-ways * gap / step, 0, 0},
                                                     .spin = {1, 2, 3}},
                                                    {.position = {32, 32, 32}}});
        const auto simulation = make_simulation(hard_model<TypeParam>(step), start);
        for (int n = 0; n < 20; ++n) {
          simulation->advance(1);
          ASSERT_TRUE(finite(simulation->packing()))
              << gap << " apart, " << ways << " ways, " << aside << " aside";
        }
      }
}

// T62: no particle at all is refused in words.
TYPED_TEST(HardCase, NoParticleIsRefused) {
  EXPECT_THROW(make_simulation(hard_model<TypeParam>(), packing_of(cube(8), {})), InputError);
}

// T62: one sphere alone, with room or touching its own images in one or all directions; none of it moves it.
TYPED_TEST(HardCase, OneSphereAloneRests) {
  for (const Triangle& edges :
       {cube(8), cube(0.9), Triangle{0.9, 4, 4, 0.5, -0.4, 0.3}, Triangle{0.7, 0.8, 0.9, 0, 0, 0}}) {
    const Packing p = after(hard_model<TypeParam>(), packing_of(edges, {{.position = {0.1, 0.2, 0.3}}}), 100);
    EXPECT_LT(norm(p.velocity[0]), 1e-15);
    EXPECT_LT(norm(p.spin[0]), 1e-15);
    double pressure = 0;
    for (const Contact& c : p.contacts) pressure += c.overlap * norm(c.branch);
    EXPECT_NEAR(p.stress.contacts.trace(), pressure, 1e-13);
  }
}

// T62: contacts of one sphere with its own images: 3 in a cube, 1 in a slab, and with those along the
// diagonals.
TYPED_TEST(HardCase, OneSphereCountsEachOfItsImagesOnce) {
  const auto contacts = [](const Triangle& edges) {
    return after(hard_model<TypeParam>(), packing_of(edges, {{}}), 0).contacts.size();
  };
  EXPECT_EQ(contacts(cube(1.01)), 0u);
  EXPECT_EQ(contacts(cube(0.9)), 3u);
  EXPECT_EQ(contacts({0.9, 4, 4, 0, 0, 0}), 1u);
  EXPECT_EQ(contacts({0.9, 0.8, 4, 0, 0, -0.45}), 3u);  // a layer of triangles
  EXPECT_EQ(contacts(cube(0.7)), 9u);                   // with the 6 face diagonals at 0.99
}

// T62: two spheres of size ratio 40, no contact ever.
TYPED_TEST(HardCase, SpheresThatNeverMeetKeepTheirMotion) {
  const Packing start = packing_of(cube(200), {{.position = {50, 50, 50}, .radius = 20},
                                               {.position = {150, 150, 150}, .velocity = {1e-3, 0, 0}}});
  const Packing p = after(hard_model<TypeParam>(), start, 10000);
  EXPECT_EQ(p.velocity, start.velocity);
  EXPECT_TRUE(p.contacts.empty());
}

// Cancellation: the start of the paper at size ratio 40 is a cell of 970 d_s, in which spheres overlap by the
// 8e-5 of a jammed packing. Where they lie costs an overlap less than 1e-9 of itself: the fraction of the
// cell is known to 2^-64, lengths to 1e-16, so 3e-12 remain.
TYPED_TEST(HardCase, OverlapsAreExactInTheLargestCell) {
  constexpr double length = 970;
  constexpr double overlap = 8e-5;
  test::Dice dice(3);
  for (int n = 0; n < 300; ++n) {
    const double radius = n % 2 == 0 ? 0.5 : 20;
    const Vec3<double> at{dice.between(0, length), dice.between(0, length), dice.between(0, length)};
    const Packing start = packing_of(
        cube(length),
        {{.position = at + (0.5 + radius - overlap) * dice.direction()}, {.position = at, .radius = radius}});
    const Packing p = after(hard_model<TypeParam>(), start, 0);
    const auto exact = test::brute_pairs(p, 0);
    ASSERT_EQ(p.contacts.size(), 1u);
    ASSERT_EQ(exact.size(), 1u);
    const auto expected = static_cast<double>(0.5L + radius - exact.begin()->second.distance);
    EXPECT_NEAR(expected, overlap, 1e-12);
    EXPECT_NEAR(p.contacts[0].overlap, expected, 1e-9 * overlap);
    EXPECT_NEAR(norm(p.force[0]), expected, 1e-9 * overlap);
  }
}

// A place just below a face, which a double cannot tell from the face itself once it is wrapped (LAMMPS issue
// 2759 lost such pairs): -1e-17 is kept as it is, to 2^-64 of the cell, and the pair is found from both
// sides.
TYPED_TEST(HardCase, NoPairIsLostAtAFace) {
  constexpr double length = 10;
  for (double tiny : {0.0, 1e-17, -1e-17, 1e-19, -1e-19, -1e-20, -1e-300, -1e-310, -5e-324})
    for (double side : {1.0, -1.0})
      for (int axis = 0; axis < 3; ++axis) {
        const auto along = [axis](double x) {
          return Vec3<double>{axis == 0 ? x : 3, axis == 1 ? x : 3, axis == 2 ? x : 3};
        };
        const Packing start =
            packing_of(cube(length), {{.position = along(tiny)}, {.position = along(side * 0.9)}});
        for (double skin : {0.0, 0.3}) {
          Model model = hard_model<TypeParam>();
          model.skin = skin;
          const Packing p = after(model, start, 0);
          ASSERT_EQ(p.contacts.size(), 1u) << tiny << " on axis " << axis;
          EXPECT_NEAR(p.contacts[0].overlap, 0.1, 1e-15);
          const Vec3<double> place = p.position(0);
          const double x = axis == 0 ? place.x : axis == 1 ? place.y : place.z;
          EXPECT_TRUE(x >= 0 && x <= length) << x;
        }
      }
}

// T43: a cell that is pressed, sheared and thinned in mid-run until its heights are a twelfth of a reach:
// nearest images become wrong on the way, rows begin to name theirs, spheres meet themselves. In every step
// the contacts are those of brute force; at last the run ends by itself and says how thin the cell was.
TYPED_TEST(HardCase, ACellThatShrinksIsRightUntilItIsRefused) {
  std::vector<Ball> balls;
  test::Dice dice(4);
  for (int k = 0; k < 5; ++k)
    balls.push_back({.position = {dice.between(0, 3), dice.between(0, 3), dice.between(0, 3)},
                     .radius = k == 0 ? 0.8 : 0.5});
  Packing start = packing_of(cube(3.9), balls);
  start.cell.rate = {-1, -0.6, -0.8, 0.4, -0.6, 0.2};
  Model model = hard_model<TypeParam>();
  model.barostat = {.pressure = 0, .inertia = 1e300};
  const auto simulation = make_simulation(model, start);
  std::size_t several = 0;
  std::size_t own = 0;
  try {
    for (int step = 0; step < 600; ++step) {
      simulation->advance(1);
      const Packing p = simulation->packing();
      std::set<test::TouchName> found;
      for (const Contact& c : p.contacts) {
        found.insert(test::name_of(p, c));
        own += c.i == c.j;
      }
      ASSERT_EQ(found.size(), p.contacts.size());
      const auto exact = test::brute_pairs(p, 0);
      for (const auto& [name, touch] : exact)
        if (!found.erase(name)) {
          ASSERT_LT(p.radius[name.i] + p.radius[name.j] - touch.distance, 1e-13) << step;
        }
      ASSERT_TRUE(found.empty()) << step;
      several += exact.size() > p.size() * (p.size() - 1) / 2;
    }
    FAIL() << "a cell of no height was not refused";
  } catch (const NumericalFailure& failure) {
    EXPECT_NE(std::string(failure.what()).find("between two of its faces are 0."), std::string::npos);
  }
  EXPECT_GT(simulation->step(), 75);
  EXPECT_GT(several, 25u);
  EXPECT_GT(own, 25u);
}

/// One large sphere of size ratio 40 and `count` small ones on its surface, evenly on a golden spiral.
Packing coated(int count, double overlap) {
  constexpr double radius = 20;
  const Vec3<double> centre{50, 50, 50};
  std::vector<Ball> balls{{.position = centre, .radius = radius}};
  for (int k = 0; k < count; ++k) {
    const double z = 1 - (2 * k + 1.0) / count;
    const double angle = k * std::numbers::pi * (3 - std::sqrt(5));
    const double across = std::sqrt(1 - z * z);
    const Vec3<double> n{across * std::cos(angle), across * std::sin(angle), z};
    balls.push_back({.position = centre + (radius + 0.5 - overlap) * n});
  }
  return packing_of(cube(100), balls);
}

// T63: a large sphere with 6400 small ones: the list has no cap. The stress of the large one's contacts is
// sum of overlap |branch|, forces cancel pair by pair.
TYPED_TEST(HardCase, LargeSphereTouchesThousandsOfSmallOnes) {
  constexpr int count = 6400;
  constexpr double overlap = 0.01;
  const auto simulation = make_simulation(hard_model<TypeParam>(), coated(count, overlap));
  const Packing start = simulation->packing();
  std::size_t of_large = 0;
  for (const Contact& c : start.contacts) {
    if (c.i != 0 && c.j != 0) continue;
    ++of_large;
    ASSERT_NEAR(c.overlap, overlap, 1e-12);
    ASSERT_NEAR(norm(c.force), overlap, 1e-12);
  }
  EXPECT_EQ(of_large, static_cast<std::size_t>(count));
  simulation->advance(20);
  const Packing end = simulation->packing();
  EXPECT_TRUE(finite(end));
  EXPECT_LT(norm(momentum(end)), 1e-12 * sum_of_forces(start));
}

}  // namespace
}  // namespace furnas
