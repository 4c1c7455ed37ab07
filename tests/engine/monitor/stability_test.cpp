#include "engine/monitor/stability.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/simulation.h"
#include "engine/trials/closed_form.h"
#include "engine/trials/row_of_two.h"
#include "tests/engine/laws/every_law.h"
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

/// Whether the motion of the row of two grows tenfold within 300 steps; otherwise it must have died out by
/// then.
template <class Law>
bool grows(double damping, double time_step) {
  const double amplitude = 1e-6;
  const auto simulation =
      make_simulation(model_of<Law>({.normal_damping = damping}, time_step), RowOfTwo::start(amplitude, {}));
  double shift = 0;
  for (int step = 0; step < 300; ++step) {
    simulation->advance(1);
    shift = std::abs(RowOfTwo::shift_of(simulation->packing()));
    if (shift > 10 * amplitude) return true;
  }
  EXPECT_LT(shift, amplitude / 10) << damping << " " << time_step;
  return false;
}

template <class Law>
class LargestStableStep : public testing::Test {};
TYPED_TEST_SUITE(LargestStableStep, EveryLaw, LawName);

/// Two spheres that touch through both images have the row sums of two contacts, which are exact here.
TYPED_TEST(LargestStableStep, PartsWhatDiesOutFromWhatGrows) {
  for (double damping : {0.1, 0.5, 3.0}) {
    // Without tangential springs and dashpots only the motion along the row limits the step.
    const AnyLaw law =
        TypeParam{{.tangential_stiffness = 0, .normal_damping = damping, .tangential_damping = 0}};
    const double limit = largest_stable_step(law, pair_of(1, 1), 2);
    EXPECT_FALSE(grows<TypeParam>(damping, 0.97 * limit)) << damping;
    EXPECT_TRUE(grows<TypeParam>(damping, 1.03 * limit)) << damping;
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
