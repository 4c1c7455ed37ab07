#include "engine/certificate/growth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "engine/certificate/certify.h"
#include "engine/certificate/statics.h"
#include "engine/trials/crystal.h"
#include "engine/trials/driven.h"
#include "tests/engine/certificate/chain.h"

namespace furnas {
namespace {

using Complex = std::complex<double>;

using test::chain;
using test::push;
using test::r;

/// What is found of a packing all of whose particles count.
Growth growth_of(const Packing& p, const HookeConstants& constants, const CellMotion& cell) {
  const ContactNetwork network = contact_network(p, {.law = HookeSynchronized{constants}});
  return find_growth(SmallMotion(network, find_backbone(network, p.species, {0, 0}), cell));
}

// A chain under pressure buckles: no dashpot feels a step across it, so that a wave q grows with the rate
// (2 (F/r) (1 - cos q)/m)^(1/2); the shortest is the fastest. By the dense matrix and by Arnoldi's method.
TEST(Growth, OfAChainThatBuckles) {
  for (const int length : {4, 40}) {
    const Growth growth = growth_of(chain(length), {.friction = 0}, {.freedom = CellFreedom::fixed});
    ASSERT_TRUE(growth.valid);
    ASSERT_FALSE(growth.modes.empty());
    const GrowingMode& fastest = growth.modes.front();
    const double expected = std::sqrt(4 * push / r / mass_of(0.5));
    EXPECT_NEAR(fastest.rate() / expected, 1, 1e-9) << length;
    EXPECT_EQ(fastest.lambda.imag(), 0);
    EXPECT_TRUE(fastest.grows());
    EXPECT_LT(fastest.residual, 1e-9);
    // The stiffness is in doubt by rounding alone: 1e-10 k_n over 2 m lambda.
    EXPECT_LT(fastest.doubt, 2 * 1e-10 / (2 * mass_of(0.5) * expected));
  }
}

// Near the end of its refinement rounding moves a rate this slow by 1e-8 of itself; the rate still counts.
// Without contacts that slide one growing wave decides, and need not be the fastest.
TEST(Growth, IsFoundHoweverSlow) {
  constexpr double little = 1e-9;  // F_n [k_n d_s]
  for (const int length : {4, 40}) {
    const Growth growth =
        growth_of(chain(length, 1 - little), {.friction = 0}, {.freedom = CellFreedom::fixed});
    EXPECT_TRUE(growth.valid);
    ASSERT_TRUE(growth.certain) << length;
    double difference = 1;
    for (int wave = 1; wave <= length / 2; ++wave) {
      const double q = 2 * std::numbers::pi * wave / length;
      const double expected = std::sqrt(2 * little * (1 - std::cos(q)) / mass_of(0.5));
      difference = std::min(difference, std::abs(growth.certain->rate() - expected));
    }
    EXPECT_LT(difference, growth.certain->doubt) << length;
  }
}

TEST(Growth, OfNothingIsNotKnown) {
  const Packing apart = packing_of({4, 4, 4, 0, 0, 0}, {{.position = {1, 1, 1}}, {.position = {3, 3, 3}}});
  for (const CellFreedom freedom : {CellFreedom::fixed, CellFreedom::triclinic}) {
    const ContactNetwork network = contact_network(apart, {});
    const Growth growth =
        find_growth(SmallMotion(network, find_backbone(network, apart.species, {}), {.freedom = freedom}));
    EXPECT_FALSE(growth.valid);
    EXPECT_TRUE(growth.modes.empty());
    const Certificate c = certify(apart, {.springs = {}, .cell = {.freedom = freedom}});
    EXPECT_FALSE(c.passed());
    EXPECT_EQ(c.backbone, 0);
  }
}

/// The part of a certificate that judges growth, of a chain whose first sphere is moved along it.
Part growth_part_of_chain(double moved) {
  constexpr int length = 4;
  std::vector<Ball> balls;
  for (int k = 0; k < length; ++k) balls.push_back({.position = {k * r + (k == 0 ? moved : 0), 2, 2}});
  const Packing p = packing_of({length * r, 4, 4, 0, 0, 0}, balls);
  const Certificate c = certify(
      p, {.springs = {.law = HookeSynchronized{{.friction = 0.3}}}, .cell = {.freedom = CellFreedom::fixed}});
  EXPECT_EQ(c.balance == Balance::off, moved != 0);
  for (const Part& part : c.parts)
    if (part.name == "stability with sliding") return part;
  return {};
}

// What grows in a state out of balance need not grow where the packing comes to rest.
TEST(Growth, IsJudgedInBalanceAlone) {
  const Part balanced = growth_part_of_chain(0);
  EXPECT_FALSE(balanced.passed());
  EXPECT_NE(balanced.note.find("not at a stable rest"), std::string::npos) << balanced.note;
  const Part moving = growth_part_of_chain(0.1 * push);
  EXPECT_TRUE(moving.passed());
  EXPECT_NE(moving.note.find("do not balance yet"), std::string::npos) << moving.note;
}

// Crystals are stable: nothing grows, with friction or without, whatever contacts see of the cell's flow.
TEST(Growth, OfCrystalsIsNone) {
  for (const double mu : {0.0, 0.5})
    for (const bool affine : {false, true})
      for (const Packing& crystal : {face_centred_primitive(r), face_centred(r, 1), face_centred(r, 2)}) {
        const ContactNetwork network = contact_network(crystal, {.law = HookeSynchronized{{.friction = mu}}});
        const CellMotion cell{.pressure = static_stress(network).trace() / 3,
                              .inertia = inertia_of_cell(crystal),
                              .affine_velocity = affine};
        const Growth growth = growth_of(crystal, {.friction = mu}, cell);
        EXPECT_TRUE(growth.valid);
        for (const GrowingMode& mode : growth.modes) EXPECT_FALSE(mode.grows()) << mode.lambda;
      }
}

/// Twice a sphere at the origin rests on another one of infinite mass, in directions at this angle, and
/// slides on both the same way round.
Packing groove(double angle, double friction) {
  Packing p = packing_of(cube(10), {{.position = {5, 5, 5}},
                                    {.position = {5 - r, 5, 5}},
                                    {.position = {5 - r * std::cos(angle), 5 - r * std::sin(angle), 5}}});
  p.mass[1] = p.mass[2] = 1e15;
  for (std::uint32_t k : {1u, 2u}) {
    const double turned = k == 1 ? 0 : angle;
    Contact c;
    c.i = 0, c.j = k;
    c.history = -friction * push * Vec3<double>{-std::sin(turned), std::cos(turned), 0};
    p.contacts.push_back(c);
  }
  return p;
}

/// The root of m x^2 + gamma m c x + (k_n - F/r) c = 0, c = 1 + i mu, with the largest real part.
Complex flutter(double friction, double damping) {
  const Complex c(1, friction);
  const Complex half = 0.5 * damping * c;
  const Complex root = std::sqrt(half * half - (1 - push / r) / mass_of(0.5) * c);
  return root.real() > 0 ? root - half : -root - half;
}

// At a right angle the forces on the sphere turn its displacement by atan mu: (k_n - F/r) (1 + mu J), J a
// quarter turn. Without damping the sphere circles outwards at any friction; damping, which is turned too,
// stops it beyond some gamma.
TEST(Growth, OfASphereThatSlidesOnTwo) {
  for (const double mu : {0.1, 0.3, 0.6})
    for (const double damping : {0.0, 0.05, 0.1, 0.5}) {
      const Growth growth =
          growth_of(groove(std::numbers::pi / 2, mu), {.normal_damping = damping, .friction = mu},
                    {.freedom = CellFreedom::fixed});
      ASSERT_TRUE(growth.valid);
      const Complex expected = flutter(mu, damping);
      if (expected.real() > 0) {
        ASSERT_FALSE(growth.modes.empty()) << mu << ' ' << damping;
        EXPECT_LT(std::abs(growth.modes.front().lambda - Complex(expected.real(), std::abs(expected.imag()))),
                  1e-9);
      } else {
        for (const GrowingMode& mode : growth.modes) EXPECT_LT(mode.rate(), 1e-6);
      }
    }
}

// The engine's own law and step: the sphere spins so fast that both contacts slide all the time, is held in
// its place by a force and starts a hair beside it. It circles outwards, or inwards, at the rates of both
// roots.
TEST(Growth, IsThatOfTheEngine) {
  constexpr double mu = 0.3;
  for (const double damping : {0.05, 0.5}) {
    Packing start = groove(std::numbers::pi / 2, mu);
    // The test's driver wants the later sphere first.
    for (Contact& c : start.contacts) std::swap(c.i, c.j), c.history = -c.history;
    start.spin[0] = {0, 0, 20};
    constexpr double aside = 1e-9;
    const Vec3<double> place = start.position(0);
    start.fraction[0] = to_fraction(inverse(start.cell.edges) * (place + Vec3<double>{aside, 0, 0}));
    constexpr double step = 0.002;
    Driven<HookeSynchronized> run(
        model_of<HookeSynchronized>({.normal_damping = damping, .tangential_damping = 0, .friction = mu},
                                    step),
        start, [](std::size_t k, const Vec3<double>&, double) {
          return k == 0 ? Vec3<double>{-push * (1 - mu), -push * (1 + mu), 0} : Vec3<double>{};
        });
    // u = x + i y moves as m u'' + gamma m c u' + (k_n - F/r) c u = 0.
    const Complex c(1, mu);
    const Complex half = 0.5 * damping * c;
    const Complex root = std::sqrt(half * half - (1 - push / r) / mass_of(0.5) * c);
    const auto expected = [&](double t) {
      const Complex a = root - half;
      const Complex b = -root - half;
      return aside * (a * std::exp(b * t) - b * std::exp(a * t)) / (a - b);
    };
    for (int stretch = 1; stretch <= 4; ++stretch) {
      run.advance(2500);
      const Vec3<double> u = run.position(0) - place;
      // A step of 0.002 is 3e-3 of the angle that a step turns: second order, over 20 time units.
      EXPECT_LT(std::abs(Complex(u.x, u.y) - expected(run.time())), 1e-4 * std::abs(expected(run.time())))
          << damping << ' ' << run.time();
    }
    EXPECT_EQ(flutter(mu, damping).real() > 0, damping < 0.1);
  }
}

}  // namespace
}  // namespace furnas
