#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "engine/monitor/energy.h"
#include "engine/trials/collision.h"
#include "tests/engine/laws/every_law.h"
#include "tests/engine/support/compaction.h"

namespace furnas {
namespace {

double gap_of(const Packing& p, const Model& model) { return p.ledger.gap(energy(p, model.law).total()); }

double relative_gap_of(const Packing& p, const Model& model) {
  return p.ledger.relative_gap(energy(p, model.law).total());
}

template <class Law>
class EnergyLedger : public testing::Test {};
TYPED_TEST_SUITE(EnergyLedger, EveryLaw, LawName);

constexpr Ball head_on{.velocity = {-0.02, 0, 0}};
constexpr Ball grazing{.velocity = {-0.02, 0.015, 0}, .spin = {0, 0.01, 0.02}};

/// Mean of |gap|/E over the entry phases of a damped collision with friction.
template <class Law>
double gap_of_a_collision(const Ball& ball, double time_step, bool winding = true) {
  const Model model = model_of<Law>({.friction = 0.3, .winding = winding}, time_step);
  constexpr int phases = 16;
  double sum = 0;
  for (int n = 0; n < phases; ++n) {
    const Packing end = bounce(model, ball, {.radius = 1}, (n + 0.5) / phases).end;
    sum += std::abs(relative_gap_of(end, model)) / phases;
  }
  return sum;
}

/// T12 for two spheres: second order, or first for a law that damps with a velocity half a step old.
TYPED_TEST(EnergyLedger, ClosesOverACollision) {
  for (const Ball& ball : {head_on, grazing}) {
    const double gap = gap_of_a_collision<TypeParam>(ball, paper_step);
    const double half = gap_of_a_collision<TypeParam>(ball, 0.5 * paper_step);
    EXPECT_LT(gap, TypeParam::synchronized ? 1e-3 : 1e-2);
    EXPECT_NEAR(gap / half, TypeParam::synchronized ? 4 : 2, 0.1);
  }
}

/// The same with the slider in series, whose spring is taken through a step to first order.
TYPED_TEST(EnergyLedger, ClosesOverACollisionWithTheSliderInSeries) {
  const double gap = gap_of_a_collision<TypeParam>(grazing, paper_step, false);
  const double half = gap_of_a_collision<TypeParam>(grazing, 0.5 * paper_step, false);
  EXPECT_LT(gap, TypeParam::synchronized ? 1e-3 : 1e-2);
  EXPECT_GT(gap / half, 1.8);
}

/// Without a tangential spring Coulomb's limit cuts the dashpot, which then does less work.
TYPED_TEST(EnergyLedger, ClosesOverACollisionWithoutATangentialSpring) {
  for (const bool winding : {true, false}) {
    const Model model = model_of<TypeParam>(
        {.tangential_stiffness = 0, .tangential_damping = 5, .friction = 0.1, .winding = winding});
    const Packing end = bounce(model, grazing, {.radius = 1}, 0.5).end;
    EXPECT_LT(std::abs(relative_gap_of(end, model)), TypeParam::synchronized ? 1e-3 : 1e-2) << winding;
  }
}

/// Without damping and friction nothing is lost, and the ledger says so exactly.
TYPED_TEST(EnergyLedger, BooksNoLossWithoutDampingAndFriction) {
  const Model model = model_of<TypeParam>({.normal_damping = 0, .tangential_damping = 0, .friction = 0});
  const Packing end = bounce(model, head_on, {.radius = 1}, 0.3).end;
  EXPECT_EQ(end.ledger.losses.total(), 0);
  EXPECT_EQ(end.ledger.cell_work, 0);
  EXPECT_GT(end.ledger.initial, 0);
  EXPECT_NEAR(gap_of(end, model) / end.ledger.initial, 0, 1e-3);
}

/// A gas that is squeezed until its spheres slide, bounce and shear, in a cell that moves.
template <class Law>
double gap_of_a_squeeze(double time_step, bool affine, double time = 12) {
  Model model = test::hasty_model(0.3);
  model.law = Law{{.friction = 0.3}};
  model.barostat.legacy = !Law::synchronized;
  model.time_step = time_step;
  model.affine_velocity = affine;
  const Packing end = after(model, test::hasty_gas(), std::lround(time / time_step));
  return std::abs(relative_gap_of(end, model));
}

TYPED_TEST(EnergyLedger, ClosesWhileTheCellMoves) {
  for (bool affine : {false, true}) {
    const double gap = gap_of_a_squeeze<TypeParam>(paper_step, affine);
    const double quarter = gap_of_a_squeeze<TypeParam>(0.25 * paper_step, affine);
    // A spring that begins between two steps misses k dt^2/(6 m_eff) of the energy of its collision, on the
    // average over phases; a collision takes 1 - e^2 of it.
    const double missed = paper_step * paper_step / (6 * reduced_mass_of(0.5, 0.5)) / (1 - 0.667 * 0.667);
    EXPECT_LT(gap, TypeParam::synchronized ? 2 * missed : 2e-2);
    EXPECT_GT(gap, 3 * quarter);
  }
}

template <class Law>
class SpringLedger : public testing::Test {};
TYPED_TEST_SUITE(SpringLedger, EveryFrictionLaw, LawName);

/// T7's pair without sliding and damping parts with the energy of its tangential spring, which is lost:
/// 1/2 k_t xi^2 of the last step before.
TYPED_TEST(SpringLedger, BooksTheSpringOfAContactThatOpens) {
  const Model model =
      model_of<TypeParam>({.normal_damping = 0, .tangential_damping = 0, .friction = 1e30}, paper_step / 16);
  const Ball oblique{.velocity = {-0.002, 0.002, 0}};
  const Packing end = bounce(model, oblique, {}, 0.5).end;
  const Losses& l = end.ledger.losses;
  const double lost = end.ledger.initial - energy(end, model.law).total();
  EXPECT_GT(lost / end.ledger.initial, 0.01);
  EXPECT_NEAR(l.opening / lost, 1, 0.01);
  EXPECT_NEAR((l.total() - l.opening) / lost, 0, 1e-3);  // the history turns within a step
}

/// Damping of two large spheres exceeds Coulomb's limit by far, so the law winds their spring up to many
/// times the energy that there is. The balance holds in each step nevertheless.
TYPED_TEST(SpringLedger, HoldsInEveryStepOfASpringThatIsWound) {
  const Model model = model_of<TypeParam>({.friction = 0.3});
  const Ball rest{.radius = 10};
  const Ball passing{.position = {20.001, 0, 0}, .velocity = {-0.01, 0.05, 0}, .radius = 10};
  const auto simulation = make_simulation(model, packing_of(cube(100), {rest, passing}));
  double wound = 0;
  double worst = 0;
  for (int step = 0; step < 2000; ++step) {
    simulation->advance(1);
    const Packing now = simulation->packing();
    wound = std::max(wound, energy(now, model.law).tangential / now.ledger.initial);
    worst = std::max(worst, std::abs(relative_gap_of(now, model)));
  }
  EXPECT_GT(wound, 100);
  EXPECT_LT(worst, 0.01);
}

bool same(const Ledger& a, const Ledger& b) {
  static_assert(sizeof(Ledger) % sizeof(double) == 0);
  return std::memcmp(&a, &b, sizeof(Ledger)) == 0;
}

TEST(Ledger, HasTheSameBitsForAnyThreadsAndReload) {
  const Model model = test::hasty_model(0.3);
  const Ledger one = after(model, test::hasty_gas(), 300).ledger;
  EXPECT_GT(one.losses.sliding, 0);
  EXPECT_GT(one.losses.opening, 0);
  for (int threads : {2, 3}) {
    const auto simulation = make_simulation(model, test::hasty_gas(), threads);
    for (int part = 0; part < 3; ++part) {
      simulation->advance(100);
      simulation->load(simulation->packing());
    }
    EXPECT_TRUE(same(simulation->packing().ledger, one)) << threads << " threads";
  }
}

/// Two spheres that never meet lose or gain by the cell's rate alone; of so few tr(e)/(3 N) takes its share.
/// The trapezoid misses (e dt)^2, 1e-8, of the work.
TEST(Ledger, BooksTheDragOfTheCell) {
  Packing start = packing_of(cube(20), {{.position = {5, 5, 5}, .velocity = {0.01, 0.02, -0.01}},
                                        {.position = {15, 15, 15}, .velocity = {-0.02, 0.01, 0.03}}});
  start.cell.rate = {4e-3, -1e-3, 2e-3, 1e-3, -2e-3, 3e-3};
  Model model = test::hasty_model(0.3);
  model.barostat.pressure = 1e-9;
  const Packing end = after(model, start, 300);
  EXPECT_EQ(end.ledger.losses.total(), 0);
  EXPECT_GT(std::abs(end.ledger.cell_work), 0.03 * end.ledger.initial);
  EXPECT_NEAR(gap_of(end, model) / end.ledger.cell_work, 0, 1e-6);
}

/// A start counts its energy anew; what goes on does not.
TEST(Ledger, BeginsWithAStart) {
  const Model model = test::hasty_model(0.3);
  Packing p = after(model, test::hasty_gas(), 300);
  EXPECT_TRUE(same(after(model, p, 0).ledger, p.ledger));
  p.order.clear();
  const Packing anew = after(model, p, 0);
  EXPECT_EQ(anew.ledger.initial, energy(anew, model.law).total());
  EXPECT_EQ(anew.ledger.losses.total(), 0);
}

}  // namespace
}  // namespace furnas
