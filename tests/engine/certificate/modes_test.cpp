#include "engine/certificate/modes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/certificate/constraints.h"
#include "engine/certificate/moduli.h"
#include "engine/certificate/statics.h"
#include "engine/trials/crystal.h"
#include "tests/engine/certificate/chain.h"

namespace furnas {
namespace {

using test::chain;
using test::push;
using test::r;

/// The backbone of all particles of a packing, with its modes and elastic constants.
struct Spectrum {
  ContactNetwork network;
  Backbone backbone;
  Modes modes;
  StrainMatrix constants;

  Spectrum(const Packing& p, double friction, CellFreedom freedom = CellFreedom::triclinic, double kt = 0.7)
      : network(contact_network(
            p, {.law = HookeSynchronized{{.tangential_stiffness = kt, .friction = friction}}})),
        backbone(find_backbone(network, p.species, {0, 1})) {
    const Stiffness stiffness(network, backbone, static_stress(network).trace() / 3);
    modes = find_modes(stiffness, freedom, 6);
    constants = modes.relaxed / network.volume;
  }
};

/// Elastic constants of a cubic crystal, in the order xx yy zz xy xz yz.
StrainMatrix cubic(double c11, double c12, double c44) {
  StrainMatrix c = StrainMatrix::Zero();
  c.topLeftCorner<3, 3>().setConstant(c12);
  c.topLeftCorner<3, 3>().diagonal().setConstant(c11);
  c.bottomRightCorner<3, 3>().diagonal().setConstant(c44);
  return c;
}

// T36 with the prestress F/r: C11 = sqrt 2 (k_n + k_t - F/r)/r, C12 = sqrt 2 (k_n - k_t + 5 F/r)/(2 r),
// C44 = sqrt 2 (k_n + k_t - 3 F/r)/(2 r), from the sum over 6 bonds a sphere in V = r^3/sqrt 2, the friction
// relaxed by the turn of the spheres. From one sphere, which touches its own images, on; the larger cells are
// factored, the smaller ones are dense matrices. 1e-11: a hundred sums and a solve.
TEST(Elasticity, OfFaceCentredCubic) {
  for (double kt : {0.0, 0.7}) {
    const double x = push / r;
    const StrainMatrix expected =
        cubic(std::sqrt(2) * (1 + kt - x) / r, std::sqrt(2) * (1 - kt + 5 * x) / (2 * r),
              std::sqrt(2) * (1 + kt - 3 * x) / (2 * r));
    const Packing crystals[] = {face_centred_primitive(r), face_centred(r, 1), face_centred(r, 2),
                                face_centred(r, 3)};
    for (const Packing& crystal : crystals) {
      const Spectrum spectrum(crystal, kt > 0 ? 0.5 : 0, CellFreedom::triclinic, kt);
      // The primitive cell stands on another axis: it has the same moduli.
      if (crystal.size() > 1) {
        EXPECT_LT((spectrum.constants - expected).norm(), 1e-11) << spectrum.constants;
      }
      EXPECT_TRUE(spectrum.modes.valid);
      EXPECT_EQ(spectrum.modes.negative, 0);
      EXPECT_GT(spectrum.modes.lowest.front(), 1e-3);
      EXPECT_LT(spectrum.modes.residual, 1e-9) << "the eigenvalues are iterated to 1e-10";
      // T35: K = (2 sqrt 2/3) (k/r + 2 k delta/r^2), whatever the friction.
      const Moduli moduli = moduli_of(spectrum.constants);
      const double first = (expected(0, 0) - expected(0, 1)) / 2;
      const double second = expected(3, 3);
      EXPECT_NEAR(moduli.bulk, 2 * std::sqrt(2) / 3 * (1 / r + 2 * push / (r * r)), 1e-11);
      EXPECT_NEAR(moduli.shear, (2 * first + 3 * second) / 5, 1e-11);
      EXPECT_NEAR(moduli.least_shear, std::min(first, second), 1e-11);
    }
  }
}

// Simple cubic: C11 = k_n/r, C12 = p = F/r^2, C44 = k_t/(2 r) - F/r^2: without friction it shears by itself,
// the three shears of its cell are its only unstable motions when it is one sphere, and their eigenvalue is
// -12 F/r, as a strain enters by its displacement L/sqrt 12.
TEST(Elasticity, OfSimpleCubicNeedsFriction) {
  const double p = push / (r * r);
  for (int cells : {1, 2, 3}) {
    const Spectrum smooth(simple_cubic(r, cells), 0);
    EXPECT_LT((smooth.constants - cubic(1 / r, p, -p)).norm(), 1e-11) << cells;
    EXPECT_NEAR(moduli_of(smooth.constants).bulk, 1 / (3 * r) + 2 * push / (3 * r * r), 1e-11);
    EXPECT_GE(smooth.modes.negative, 3);
    const Spectrum rough(simple_cubic(r, cells), 0.5);
    EXPECT_LT((rough.constants - cubic(1 / r, p, 0.7 / (2 * r) - p)).norm(), 1e-11) << cells;
    EXPECT_EQ(rough.modes.negative, 0) << cells;
  }
  const Spectrum one(simple_cubic(r, 1), 0);
  EXPECT_EQ(one.modes.negative, 3);
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(one.modes.lowest[std::size_t(k)], -12 * push / r, 1e-13);
}

// A chain under pressure buckles: a transverse wave q has the eigenvalue -2 (F/r) (1 - cos q), in two
// directions, q = 2 pi m/n without m = 0. Counted both by the dense matrix and by the factors.
TEST(Modes, OfAChainThatBuckles) {
  for (int length : {4, 12, 40}) {
    const Spectrum spectrum(chain(length), 0, CellFreedom::fixed);
    EXPECT_EQ(spectrum.modes.negative, 2 * (length - 1)) << length;
    EXPECT_EQ(spectrum.modes.unstable(), 2 * (length - 1)) << length << ": it is in balance";
    const auto wave = [&](int m) {
      return -2 * push / r * (1 - std::cos(2 * std::numbers::pi * m / length));
    };
    // The shortest wave is the lowest. Of few unknowns six are seen, of many all that are negative.
    const auto& lowest = spectrum.modes.lowest;
    EXPECT_NEAR(lowest.front(), wave(length / 2), length < 40 ? 1e-14 : 1e-12) << length;
    if (length < 40) continue;
    for (int m = 1; m < length / 2; ++m)  // two of each wave, in two directions
      for (std::size_t k = 0; k < 4; ++k)
        EXPECT_NEAR(lowest[static_cast<std::size_t>(2 * (length - 1) - 4 * m) + k], wave(m), 1e-12) << m;
  }
}

// So many pivots are negative that L D L^T counts them instead of holds.
TEST(Modes, OfALongChainAreCountedByItsPivots) {
  constexpr int length = 400;
  const Modes modes = Spectrum(chain(length), 0, CellFreedom::fixed).modes;
  EXPECT_TRUE(modes.valid);
  EXPECT_EQ(modes.negative, 2 * (length - 1));
}

// Two spheres in a row with the forces F and G, each with its neighbour's image: side by side they step with
// the eigenvalue -2 (F/r + G/s), in two directions. Each sphere lacks |F - G|, so that it is in doubt by 4 |F
// - G| (1/r + 1/s). In balance it is unstable, and nearly so, too; were the row pressed by F alone, nobody
// could say.
TEST(Modes, AreOpenWhereTheImbalanceIsAsLargeAsThePrestress) {
  const auto row = [](double f, double g) {
    return packing_of({2 - f - g, 4, 4, 0, 0, 0}, {{.position = {1, 2, 2}}, {.position = {2 - f, 2, 2}}});
  };
  struct Row {
    double f, g;
    std::int64_t unstable;
  };
  for (const auto& [f, g, unstable] : {Row{0.02, 0.02, 2}, {0.02, 0.019, 2}, {0.02, 0.001, 0}}) {
    const Modes modes = Spectrum(row(f, g), 0, CellFreedom::fixed).modes;
    ASSERT_EQ(modes.negative, 2);
    for (std::size_t k : {0u, 1u}) {
      EXPECT_NEAR(modes.lowest[k], -2 * (f / (1 - f) + g / (1 - g)), 1e-14);
      EXPECT_NEAR(modes.doubt[k], 4 * (f - g) * (1 / (1 - f) + 1 / (1 - g)), 1e-14);
    }
    EXPECT_EQ(modes.unstable(), unstable) << g;
  }
}

// A negative eigenvalue that is not among those shown may be in doubt or not: it counts as unstable. One that
// no spring and no force resists is so beyond doubt.
TEST(Modes, AreOpenOnlyWhenSeenAndHeldByForces) {
  Modes modes{.valid = true, .negative = 3, .lowest = {-1e-8, -1e-9}, .doubt = {2e-8, 2e-8}};
  EXPECT_EQ(modes.unstable(), 1);
  modes = {.valid = true, .negative = 0, .lowest = {1e-17}, .doubt = {1e-16}};
  EXPECT_EQ(modes.unstable(), 1);
}

// Two simple cubic crystals, one in the gaps of the other and without a hold on it, slide past each other.
TEST(Modes, OfTwoPiecesAreFlat) {
  Packing both = simple_cubic(r, 2);
  const std::size_t count = both.size();
  both.resize(2 * count);
  for (std::size_t k = 0; k < count; ++k) {
    both.fraction[count + k] = to_fraction(in_unit_cell(both.fraction[k]) + Vec3<double>{0.25, 0.25, 0.25});
    both.radius[count + k] = both.radius[k];
  }
  const ContactNetwork network = contact_network(both, {.law = HookeSynchronized{{.friction = 0.5}}});
  Backbone backbone = find_backbone(network, both.species, {0, 1});
  EXPECT_EQ(
      std::erase_if(backbone.bonds, [&](const StaticContact* c) { return (c->i < count) != (c->j < count); }),
      8 * count);
  EXPECT_EQ(percolation(backbone).pieces, 2);
  const Modes modes = find_modes(Stiffness(network, backbone, 0), CellFreedom::fixed, 6);
  EXPECT_FALSE(modes.valid && modes.unstable() == 0);
}

// Maxwell's count of crystals: contacts a sphere are 3 (simple cubic) and 6 (face-centred).
TEST(Constraints, AreCountedWithTheCell) {
  const auto count = [](const Packing& crystal, double friction, CellFreedom freedom) {
    const Spectrum spectrum(crystal, friction);
    return count_constraints(spectrum.network, spectrum.backbone, freedom);
  };
  const Packing crystal = simple_cubic(r, 3);
  EXPECT_EQ(count(crystal, 0, CellFreedom::triclinic).constraints, 81);
  EXPECT_EQ(count(crystal, 0, CellFreedom::triclinic).needed, 3 * 27 + 3);
  EXPECT_EQ(count(crystal, 0, CellFreedom::orthorhombic).needed, 3 * 27);
  EXPECT_EQ(count(crystal, 0, CellFreedom::cubic).needed, 3 * 27 - 2);
  EXPECT_EQ(count(crystal, 0, CellFreedom::fixed).needed, 3 * 27 - 2);
  EXPECT_EQ(count(crystal, 0.5, CellFreedom::triclinic).constraints, 3 * 81);
  EXPECT_EQ(count(crystal, 0.5, CellFreedom::triclinic).needed, 6 * 27 + 3);
  // One that slides holds two components.
  Spectrum sliding(crystal, 0.5);
  sliding.network.contacts[5].sliding = true;
  EXPECT_EQ(count_constraints(sliding.network, sliding.backbone, CellFreedom::triclinic).constraints,
            3 * 81 - 1);
}

}  // namespace
}  // namespace furnas
