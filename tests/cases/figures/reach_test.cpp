#include "cases/program/figures/reach.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/cases/figures/made_points.h"

namespace furnas {
namespace {

/// Shares of rattlers that scatter as they say, at size ratio 10.
TEST(Reach, IsPooledForTheRattlers) {
  Study study = with_a_lone_sample(0.002, 0.82, 25);
  for (Point& p : study.curves.front().points)
    p.small_rattlers[0] = mean_interval({0.49, 0.50, 0.51});  // 100 large spheres, 0.01
  Point lone = point(20, 0.29, 0.3, {0.8}, 25);
  lone.small_rattlers[0] = mean_interval({0.7});
  EXPECT_NEAR(Reach(study).of_small_rattlers(lone, 0), 2.44691 * 0.02, 1e-6);
  lone.small_rattlers[0] = mean_interval({0.6, 0.7, 0.8});
  lone.phi_J = {0.8, 0.8, 0.8};
  EXPECT_NEAR(Reach(study).of_small_rattlers(lone, 0), 4.30265 * 0.1 / std::sqrt(3.0), 1e-5)
      << "three samples have their own";
}

TEST(Reach, NeedsFiveDegreesAndLargeSizeRatios) {
  Study study = with_a_lone_sample(0.002, 0.82, 25);
  study.curves.front().points.pop_back();
  EXPECT_FALSE(Reach(study).pools(point(20, 0.29, 0.3, {0.8}))) << "four degrees";
  study = with_a_lone_sample(0.002, 0.82, 25);
  study.curves.push_back({{point(4, 0.29, 0.3, {0.8})}});
  EXPECT_FALSE(Reach(study).pools(point(4, 0.29, 0.3, {0.8}))) << "size ratio 4";
  for (Point& p : study.curves.front().points) p.size_ratio = 4;
  EXPECT_FALSE(Reach(study).pools(point(20, 0.29, 0.3, {0.8}))) << "of size ratio 4";
  EXPECT_NEAR(Reach(study).of_phi_J(point(20, 0.29, 0.3, {0.8, 0.81})), 12.7062 * 0.005, 1e-5)
      << "two samples have Student's";
}

/// Near a maximum is where the curve has it, not where the model has it.
TEST(Reach, KnowsTheMaximumOfACurve) {
  Study study = with_a_lone_sample(0.002, 0.82, 25);
  Curve peaked;
  for (const auto& [f, phi] : {std::pair{0.1, 0.65}, {0.15, 0.70}, {0.2, 0.75}, {0.25, 0.72}, {0.3, 0.70}})
    peaked.points.push_back(point(20, f, 0.3, {phi}));
  study.curves.back() = peaked;  // f_max 0.2; of the model 0.29
  const Reach reach(study);
  EXPECT_TRUE(reach.pools(point(20, 0.2, 0.3, {0.75})));
  EXPECT_FALSE(reach.pools(point(20, 0.29, 0.3, {0.7}))) << "far above, where nothing is pooled";
}

TEST(Reach, IsPooledOnOneSideOfTheMaximum) {
  Study study = with_a_lone_sample(0.002, 0.82, 25);
  study.curves.push_back({{point(20, 0.29, 0.0, {0.8})}});
  study.mono.insert(study.mono.begin(), point(1, 0, 0.0, {0.637, 0.638, 0.639}));
  const Reach reach(study);
  EXPECT_FALSE(reach.pools(point(20, 0.27, 0.0, {0.8}))) << "no samples without friction";
  EXPECT_TRUE(reach.pools(point(20, 0.29, 0.3, {0.8})));
  EXPECT_TRUE(reach.pools(point(20, 0.29, 0.3, {0.8, 0.9})));
  EXPECT_FALSE(reach.pools(point(20, 0.29, 0.3, {0.8, 0.81, 0.82}))) << "three samples know their scatter";
  EXPECT_FALSE(reach.pools(point(20, 0.2, 0.3, {0.8}))) << "no samples below f_max";
  EXPECT_FALSE(reach.pools(point(20, 0.29, 0.1, {0.8}))) << "no model at this friction";
  EXPECT_TRUE(std::isinf(reach.of_phi_J(point(20, 0.2, 0.3, {0.8}))));
  Point settled = point(20, 0.29, 0.3, {0.8});
  const double jammed = reach.of_phi_J(settled);
  settled.phi_bound = 1e-3;
  EXPECT_NEAR(reach.of_phi_J(settled), jammed + 1e-3, 1e-12);
}

/// Below f_max, where the large spheres alone carry the load, samples scatter by 0.01; near it by 0.002, and
/// small spheres carry load.
TEST(Reach, IsThatOfTheGroupThatScattersMore) {
  Study study = with_a_lone_sample(0.002, 0.82, 25);
  const auto with_rattlers = [](Point p, double share) {
    p.small_rattlers[0] = mean_interval({share});
    return p;
  };
  for (Point& p : study.curves.front().points) p = with_rattlers(p, 0.2);
  for (const double f : {0.1, 0.15, 0.2})
    study.curves.front().points.push_back(with_rattlers(point(10, f, 0.3, {0.69, 0.70, 0.71}), 0.99));
  const Reach reach(study);
  const auto reach_at = [&](double f, double share) {
    return reach.of_phi_J(with_rattlers(point(20, f, 0.3, {0.8}, 25), share));
  };
  constexpr double t6 = 2.44691;
  EXPECT_NEAR(reach_at(0.29, 0.2), t6 * 0.004, 1e-6);
  EXPECT_NEAR(reach_at(0.29, 0.9), t6 * 0.02, 1e-6) << "near f_max, but of large spheres alone";
  EXPECT_NEAR(reach_at(0.2, 0.9), t6 * 0.02, 1e-6);
}

}  // namespace
}  // namespace furnas
