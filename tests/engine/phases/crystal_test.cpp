#include "engine/trials/crystal.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/engine/laws/every_law.h"
#include "tests/engine/support/setups.h"

namespace furnas {
namespace {

constexpr double k = 1;  // k_n

double pressure_of_simple_cubic(double r) { return k * (1 - r) / (r * r); }
double pressure_of_face_centred(double r) { return 2 * std::sqrt(2) * k * (1 - r) / (r * r); }

template <class Law>
class Crystal : public testing::Test {};
TYPED_TEST_SUITE(Crystal, EveryLaw, LawName);

// T35: simple cubic: p = k delta/r^2, isotropic, from one sphere that touches its own images to 4^3 spheres,
// and in skewed cells of the same lattice.
TYPED_TEST(Crystal, PressureOfSimpleCubic) {
  const Model model = model_of<TypeParam>({.friction = 0.5});
  constexpr double r = 0.95;
  std::vector<Packing> crystals;
  for (int cells : {1, 2, 3, 4}) crystals.push_back(simple_cubic(r, cells));
  for (int cells : {1, 2, 4})
    for (int skew : {-1, 1, 2}) crystals.push_back(reskewed(simple_cubic(r, cells), skew, -1, 1));
  for (const Packing& crystal : crystals) {
    const Packing p = with_forces(model, crystal);
    EXPECT_EQ(p.contacts.size(), 3 * p.size());
    const Eigen::Matrix3d stress = p.stress.contacts / p.cell.volume();
    EXPECT_LT((stress - pressure_of_simple_cubic(r) * Eigen::Matrix3d::Identity()).norm(),
              1e-13 * pressure_of_simple_cubic(r))
        << p.size() << " spheres, tilt " << p.cell.edges.xy;
    for (const Vec3<double>& f : p.force) EXPECT_LT(norm(f), 1e-14);
  }
}

// T35: face-centred cubic: p = 2 sqrt 2 k delta/r^2, isotropic.
TYPED_TEST(Crystal, PressureOfFaceCentredCubic) {
  const Model model = model_of<TypeParam>({.friction = 0.5});
  constexpr double r = 0.95;
  std::vector<Packing> crystals{face_centred_primitive(r)};
  for (int cells : {1, 2, 3, 4}) crystals.push_back(face_centred(r, cells));
  crystals.push_back(reskewed(face_centred_primitive(r), 1, -1, 1));
  crystals.push_back(reskewed(face_centred(r, 2), -1, 1, 1));
  for (const Packing& crystal : crystals) {
    const Packing p = with_forces(model, crystal);
    EXPECT_EQ(p.contacts.size(), 6 * p.size());
    const Eigen::Matrix3d stress = p.stress.contacts / p.cell.volume();
    EXPECT_LT((stress - pressure_of_face_centred(r) * Eigen::Matrix3d::Identity()).norm(),
              1e-13 * pressure_of_face_centred(r))
        << p.size() << " spheres, tilt " << p.cell.edges.xy;
    for (const Vec3<double>& f : p.force) EXPECT_LT(norm(f), 1e-14);
  }
}

// T35: bulk modulus -V dp/dV: simple cubic k/(3r) + 2 k delta/(3 r^2), face-centred (2 sqrt 2/3) (k/r + 2 k
// delta/r^2). The difference quotient is of fourth order; rounding over its step leaves 1e-10.
TYPED_TEST(Crystal, BulkModulus) {
  const Model model = model_of<TypeParam>({.friction = 0.5});
  constexpr double r = 0.95;
  constexpr double h = 1e-3;
  const auto modulus = [&](auto&& crystal) {
    const auto p = [&](double x) { return contact_pressure(with_forces(model, crystal(r * (1 + x)))); };
    return -(8 * (p(h) - p(-h)) - (p(2 * h) - p(-2 * h))) / (12 * h) / 3;
  };
  const double delta = 1 - r;
  EXPECT_NEAR(modulus([](double x) { return simple_cubic(x, 1); }), k / (3 * r) + 2 * k * delta / (3 * r * r),
              1e-10);
  EXPECT_NEAR(modulus([](double x) { return face_centred_primitive(x); }),
              2 * std::sqrt(2) / 3 * (k / r + 2 * k * delta / (r * r)), 1e-10);
}

template <class Law>
class Elasticity : public testing::Test {};
TYPED_TEST_SUITE(Elasticity, EveryFrictionLaw, LawName);

// T36: face-centred cubic with stuck contacts, delta -> 0: C11 = sqrt 2 (k_n + k_t)/r,
// C12 = sqrt 2 (k_n - k_t)/(2 r), C44 = sqrt 2 (k_n + k_t)/(2 r).
TYPED_TEST(Elasticity, OfFaceCentredCubicReachesTheTangentialSprings) {
  constexpr double r = 1 - 1e-4;
  for (double kt : {1.0, 0.5})
    for (int cells : {1, 2}) {
      const Packing crystal = face_centred(r, cells);
      const double c11 = std::sqrt(2) * (1 + kt) / r;
      const double c12 = std::sqrt(2) * (1 - kt) / (2 * r);
      const double c44 = shear_modulus_of_face_centred(r, kt);
      const Model sticking = model_of<TypeParam>(
          {.tangential_stiffness = kt, .normal_damping = 0, .tangential_damping = 0, .friction = no_sliding});
      // Pressure counts positive, so stresses fall as strains grow.
      const Eigen::Matrix3d stretched = -stress_per_strain(sticking, crystal, {1, 0, 0, 0, 0, 0});
      EXPECT_NEAR(stretched(0, 0) / c11, 1, 1e-3);
      EXPECT_NEAR(stretched(1, 1), c12, 1e-3);
      EXPECT_NEAR(stretched(2, 2), c12, 1e-3);
      const Triangle shears[] = {{0, 0, 0, 1, 0, 0}, {0, 0, 0, 0, 1, 0}, {0, 0, 0, 0, 0, 1}};
      const int row[] = {1, 0, 0};
      const int column[] = {2, 2, 1};
      for (int n = 0; n < 3; ++n) {
        const Eigen::Matrix3d sheared = -stress_per_strain(sticking, crystal, shears[n]);
        EXPECT_NEAR(sheared(row[n], column[n]) / c44, 1, 1e-3);
        EXPECT_NEAR(sheared(column[n], row[n]) / c44, 1, 1e-3);
      }
    }
}

}  // namespace
}  // namespace furnas
