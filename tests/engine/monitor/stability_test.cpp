#include "engine/monitor/stability.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>

#include "engine/trials/closed_form.h"
#include "tests/engine/support/setups.h"

namespace furnas {
namespace {

const AnyLaw usual = HookeSynchronized{{.friction = 0.3}};

Touch<double> pair_of(double diameter_i, double diameter_j) {
  const double mass_i = mass_of(diameter_i / 2), mass_j = mass_of(diameter_j / 2);
  return resting_touch(diameter_i / 2, diameter_j / 2, reduced_mass(mass_i, mass_j), 0);
}

TEST(Restitution, FollowsTheClosedFormOfEachPair) {
  struct Pair {
    double a, b, restitution;
  };
  for (const Pair& pair : {Pair{1, 1, 0.66685}, Pair{1, 2, 0.58055}, Pair{1, 40, 0.56111},
                           Pair{2, 2, 0.29546}, Pair{3, 3, 0.06113}}) {
    EXPECT_NEAR(restitution(usual, pair_of(pair.a, pair.b)), pair.restitution, 5e-6);
    EXPECT_NEAR(restitution(usual, pair_of(pair.b, pair.a)), restitution(usual, pair_of(pair.a, pair.b)),
                1e-15);
  }
  EXPECT_EQ(restitution(HookeSynchronized{{.normal_damping = 0}}, pair_of(1, 1)), 1);
}

/// Two large spheres creep apart from alpha = 3.94 on: 1/m_eff = gamma^2/4.
TEST(Restitution, VanishesWhereThePairIsOverdamped) {
  const double limit = std::cbrt(2 * 16 * 6 / std::numbers::pi);
  EXPECT_NEAR(limit, 3.94, 0.005);
  EXPECT_GT(restitution(usual, pair_of(0.999 * limit, 0.999 * limit)), 0);
  EXPECT_EQ(restitution(usual, pair_of(1.001 * limit, 1.001 * limit)), 0);
  EXPECT_FALSE(collision_time(usual, pair_of(1.001 * limit, 1.001 * limit)));
}

TEST(PairFrequency, IsThatOfTheStifferMode) {
  const double m_eff = mass_of(0.5) / 2;
  EXPECT_NEAR(pair_frequency(usual, pair_of(1, 1)), std::sqrt(3.5 / m_eff), 1e-13);
  EXPECT_NEAR(
      pair_frequency(HookeSynchronized{{.tangential_stiffness = 0.1, .friction = 0.3}}, pair_of(1, 1)),
      std::sqrt(1 / m_eff), 1e-13);
  EXPECT_NEAR(pair_frequency(Frictionless<false>{}, pair_of(1, 1)), std::sqrt(1 / m_eff), 1e-13);
}

/// How far a pair with the step `dt` strays in 400 steps of x'' = -x/m_eff - gamma x', the force being taken
/// at the start of each step.
double strays(double dt, double stiffness, double damping) {
  double x = 1e-3, v = 0, largest = 0;
  for (int n = 0; n < 400; ++n) {
    const double a = -stiffness * x - damping * v;
    v += dt * a, x += dt * v;
    largest = std::max(largest, std::abs(x));
  }
  return largest / 1e-3;
}

TEST(LargestStableStep, PartsWhatStaysFromWhatGrows) {
  for (double damping : {0.0, 0.5, 3.0}) {
    const AnyLaw law = Frictionless<false>{{.normal_damping = damping}};
    const Touch<double> pair = pair_of(1, 1);
    const double limit = largest_stable_step(law, pair), stiffness = 1 / pair.reduced_mass;
    EXPECT_LT(strays(0.99 * limit, stiffness, damping), 1e3) << damping;
    EXPECT_GT(strays(1.05 * limit, stiffness, damping), 1e6) << damping;
  }
}

/// Two equal spheres that stick: normal mode k/m_eff, tangential mode with rotation 3.5 k_t/m_eff, so the
/// bound is exact.
TEST(StiffestStep, IsExactForAStickingPair) {
  Packing p = packing_of(cube(10), {{.position = {1, 1, 1}}, {.position = {1.9, 1, 1}}});
  Model model = model_of<HookeSynchronized>({.friction = 0.3});
  p = after(model, p, 0);
  const double m_eff = 0.5 * mass_of(0.5);
  EXPECT_NEAR(stiffest_step(p, model), model.time_step * std::sqrt(3.5 / m_eff), 1e-14);
  Model smooth = model_of<Frictionless<false>>({});
  EXPECT_NEAR(stiffest_step(p, smooth), smooth.time_step * std::sqrt(1 / m_eff), 1e-14);
}

/// Frictionless springs of the jammed packing: the largest eigenvalue of M^-1 K, with K built by hand.
TEST(StiffestStep, BoundsTheFrequenciesOfAPacking) {
  const Packing& p = jammed();
  const auto n = static_cast<Eigen::Index>(3 * p.size());
  Eigen::MatrixXd k = Eigen::MatrixXd::Zero(n, n);
  for (const Contact& c : p.contacts) {
    const Eigen::Vector3d normal = Eigen::Vector3d(c.branch.x, c.branch.y, c.branch.z).normalized();
    Eigen::VectorXd u = Eigen::VectorXd::Zero(n);
    u.segment<3>(3 * c.i) += normal / std::sqrt(p.mass[c.i]);
    u.segment<3>(3 * c.j) -= normal / std::sqrt(p.mass[c.j]);
    k += u * u.transpose();
  }
  Model model = jammed_model();
  model.law = Frictionless<false>{};
  const double exact =
      model.time_step *
      std::sqrt(
          Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(k, Eigen::EigenvaluesOnly).eigenvalues()(n - 1));
  const double bound = stiffest_step(p, model);
  EXPECT_GE(bound, exact);
  EXPECT_LT(bound, 2 * exact);  // and is not idle
}

}  // namespace
}  // namespace furnas
