#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/base/random.h"
#include "tests/engine/laws/every_law.h"
#include "tests/engine/support/setups.h"

namespace furnas {
namespace {

template <class Law>
class ElasticForces : public testing::Test {};
TYPED_TEST_SUITE(ElasticForces, EveryLaw, LawName);

const Triangle skewed{6.5, 6, 7, 0.9, -1.3, 2.1};

/// Spheres at random in a skewed cell, deep in each other so that no contact opens or closes nearby.
Packing crowd() {
  std::vector<Ball> balls;
  for (std::uint32_t k = 0; k < 60; ++k) {
    const auto w = philox({k, 0, 0, 0}, 5);
    const auto unit = [](std::uint32_t x) { return x / 4294967296.0; };
    balls.push_back(
        {.position = skewed * Vec3<double>{unit(w[0]), unit(w[1]), unit(w[2])}, .radius = k < 6 ? 1.5 : 0.5});
  }
  return packing_of(skewed, balls);
}

HookeConstants elastic() { return {.normal_damping = 0, .tangential_damping = 0, .friction = 0}; }

template <class Law>
double energy(const Packing& start) {
  return elastic_energy(after(model_of<Law>(elastic()), start, 0));
}

/// Fourth-order difference of the energy along a change of the packing.
template <class Law, class Change>
double slope(double h, const Change& change) {
  const auto at = [&](double x) {
    Packing p = crowd();
    change(p, x);
    return energy<Law>(p);
  };
  return (8 * (at(h) - at(-h)) - (at(2 * h) - at(-2 * h))) / (12 * h);
}

// T33: F = -dE/dx, mu = 0.
TYPED_TEST(ElasticForces, AreTheGradientOfTheEnergy) {
  const Packing p = after(model_of<TypeParam>(elastic()), crowd(), 0);
  ASSERT_GT(p.contacts.size(), 60u);
  double typical = 0;
  for (const Vec3<double>& f : p.force) typical = std::max(typical, norm(f));
  for (std::size_t k : {0u, 3u, 10u, 25u, 59u}) {
    const auto along = [&](const Vec3<double>& direction) {
      return slope<TypeParam>(1e-4, [&](Packing& q, double x) {
        const Fraction shift = to_fraction(inverse(q.cell.edges) * (x * direction));
        q.fraction[k] = {q.fraction[k].x + shift.x, q.fraction[k].y + shift.y, q.fraction[k].z + shift.z};
      });
    };
    const Vec3<double> numeric{-along({1, 0, 0}), -along({0, 1, 0}), -along({0, 0, 1})};
    EXPECT_LT(norm(numeric - p.force[k]), 1e-8 * typical) << k;
  }
}

// T33: P_ab V = -dE/d strain_ab for the six strains of an upper-triangular cell, mu = 0.
TYPED_TEST(ElasticForces, StressIsTheDerivativeByTheStrain) {
  const Eigen::Matrix3d stress = after(model_of<TypeParam>(elastic()), crowd(), 0).stress.contacts;
  EXPECT_LT((stress - stress.transpose()).norm(), 1e-12 * stress.norm());
  const Triangle strains[] = {{1, 0, 0, 0, 0, 0}, {0, 1, 0, 0, 0, 0}, {0, 0, 1, 0, 0, 0},
                              {0, 0, 0, 1, 0, 0}, {0, 0, 0, 0, 1, 0}, {0, 0, 0, 0, 0, 1}};
  const int row[] = {0, 1, 2, 1, 0, 0};
  const int column[] = {0, 1, 2, 2, 2, 1};
  for (int n = 0; n < 6; ++n) {
    const double numeric = slope<TypeParam>(2e-5, [&](Packing& q, double x) {
      const Triangle& e = strains[n];
      q.cell.edges =
          product({1 + x * e.xx, 1 + x * e.yy, 1 + x * e.zz, x * e.yz, x * e.xz, x * e.xy}, q.cell.edges);
    });
    EXPECT_NEAR(-numeric, stress(row[n], column[n]), 1e-8 * stress.norm()) << row[n] << column[n];
  }
}

// T16 in a packing: |F_t| <= mu |F_n| on every contact in every step. The bound is of the size of the force's
// rounding: its parts along and across the normal are taken from their sum. The damping, m_eff gamma times
// the slip, is across the normal only to the rounding of the velocities, which may be far larger than a force
// in which spring and damping cancel.
TEST(Friction, NeverExceedsCoulombInAPacking) {
  const double friction = 0.3;
  const auto simulation = make_simulation(jammed_model(), jammed());
  std::size_t sliding = 0;
  for (int step = 0; step < 200; ++step) {
    simulation->advance(1);
    const Packing p = simulation->packing();
    for (const Contact& c : p.contacts) {
      const Vec3<double> n = c.branch * (1 / norm(c.branch));
      const double normal = dot(c.force, n);
      const double damping = HookeConstants{}.tangential_damping *
                             reduced_mass_of(p.radius[c.i], p.radius[c.j]) *
                             norm(p.velocity[c.i] - p.velocity[c.j]);
      const double rounding = 2e-15 * norm(c.force) + 1e-15 * friction * damping;
      ASSERT_LE(norm(c.force - normal * n), friction * std::abs(normal) + rounding);
      sliding += c.sliding;
    }
  }
  EXPECT_GT(sliding, 0u);
}

}  // namespace
}  // namespace furnas
