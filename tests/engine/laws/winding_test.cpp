#include <gtest/gtest.h>

#include <cmath>

#include "tests/engine/laws/every_law.h"
#include "tests/engine/support/setups.h"

namespace furnas {
namespace {

/// A contact that stays and slides at constant speed, step by step.
template <class Law>
class Sliding : public testing::Test {
 protected:
  /// Two spheres of this radius, pressed into each other by `overlap` [d_s].
  void press(double radius, double overlap, double slip) {
    touch.distance = 2 * radius - overlap;
    touch.branch = {touch.distance, 0, 0};
    touch.overlap = overlap;
    touch.radius_i = touch.radius_j = radius;
    touch.reduced_mass = reduced_mass_of(radius, radius);
    touch.midway.velocity = touch.now.velocity = {0, slip, 0};
    touch.time_step = paper_step;
    limit = friction * overlap;
    dashpot = 0.5 * touch.reduced_mass;
  }

  void slide(bool winding, int steps) {
    const Law law{{.friction = friction, .winding = winding}};
    for (int step = 0; step < steps; ++step) {
      const Reaction<double> r = law(touch, history);
      force = r.force;
      losses += r.losses.sliding + r.losses.tangential_damping;
    }
  }

  static constexpr double friction = 0.3;
  Touch<double> touch{};
  double limit{}, dashpot{};
  Vec3<double> force, history;
  double losses = 0;
};
TYPED_TEST_SUITE(Sliding, EveryFrictionLaw, LawName);

constexpr double large = 10;
constexpr double overlap = 5;
constexpr double slip = 0.05;

// A slider in series with spring and dashpot: c xi' + k xi = limit, so xi = limit/k (1 - exp(-k t/c)).
TYPED_TEST(Sliding, RelaxesToTheLimitWhenTheSliderIsInSeries) {
  this->press(large, overlap, slip);
  ASSERT_GT(this->dashpot * slip, 10 * this->limit) << "damping alone is far beyond the limit";
  constexpr int steps = 30'000;
  this->slide(false, steps);
  const double time = steps * paper_step;
  const double xi = this->limit * (1 - std::exp(-time / this->dashpot));
  EXPECT_NEAR(this->history.y, xi, 1e-3 * xi);
  EXPECT_NEAR(this->force.y, -this->limit, 1e-12);
  EXPECT_NEAR(this->losses, this->limit * slip * time - 0.5 * xi * xi, 1e-3 * this->losses)
      << "what the motion has lost and the spring has not got";
}

// The rule of the paper: spring and damping of the whole slip make up the limit, k xi + c v = limit.
TYPED_TEST(Sliding, WindsTheSpringTheOtherWayAsInTheStudy) {
  this->press(large, overlap, slip);
  this->slide(true, 100);
  EXPECT_NEAR(this->history.y, this->limit - this->dashpot * slip, 1e-9);
  EXPECT_LT(this->history.y, -25) << "many diameters";
  EXPECT_NEAR(this->force.y, -this->limit, 1e-12);
}

TYPED_TEST(Sliding, IsTheSameForBothRulesWhereDampingIsWeak) {
  this->press(0.5, 1e-4, 1e-9);
  for (bool winding : {false, true}) {
    this->history = {0, this->limit, 0};
    this->slide(winding, 100);
    EXPECT_NEAR(this->history.y, this->limit, 1e-4 * this->limit) << winding;
  }
}

}  // namespace
}  // namespace furnas
