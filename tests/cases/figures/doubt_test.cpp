#include <gtest/gtest.h>

#include "cases/figures/report.h"

// What statements make of intervals that are too wide.

namespace furnas {
namespace {

Point point(double size_ratio, double small_fraction, double friction, std::vector<double> phi_J,
            std::int64_t large = 100) {
  Point p;
  p.size_ratio = size_ratio;
  p.small_fraction = small_fraction;
  p.friction = friction;
  p.large = large;
  p.samples = p.jammed = phi_J.size();
  p.mean_phi_J = mean_interval(phi_J);
  p.phi_J = std::move(phi_J);
  return p;
}

Finding finding(const Study& study, const std::string& what) {
  for (const Statement& s : statements_of(study))
    if (s.what.find(what) != s.what.npos) return s.finding;
  throw std::runtime_error(what);
}

Finding of_number(std::vector<double> phi_J, std::int64_t large = 100) {
  Study study;
  study.curves = {{{point(20, 0.29, 0.3, std::move(phi_J), large)}}};
  return finding(study, "α = 20, μ = 0.3, f_s = 0.29");  // 0.823
}

TEST(Doubt, AnIntervalThatHoldsNearlyAllAgreesWithNothing) {
  EXPECT_EQ(of_number({0.820, 0.821, 0.822}), Finding::reproduced);
  EXPECT_EQ(of_number({0.80, 0.85}), Finding::not_reachable);
  EXPECT_EQ(of_number({0.75, 0.77}), Finding::not_reachable);
  EXPECT_EQ(of_number({0.760, 0.761, 0.762}), Finding::not_reproduced);
}

TEST(Doubt, ALoneSampleCountsIfItIsLarge) {
  EXPECT_EQ(of_number({0.82}), Finding::not_reachable);
  EXPECT_EQ(of_number({0.82}, 1000), Finding::reproduced);
  EXPECT_EQ(of_number({0.76}, 1000), Finding::not_reproduced);
}

Finding of_curve(double first, double middle, double last, double scatter) {
  Study study;
  const auto at = [&](double f, double phi) { return point(3, f, 0.3, {phi - scatter, phi, phi + scatter}); };
  study.curves = {{{at(0.1, first), at(0.3, middle), at(0.5, last)}}};
  return finding(study, "rises to a maximum");
}

TEST(Doubt, AMaximumIsToldFromScatter) {
  EXPECT_EQ(of_curve(0.65, 0.70, 0.66, 0.001), Finding::reproduced);
  EXPECT_EQ(of_curve(0.65, 0.70, 0.66, 0.05), Finding::not_reachable);
  EXPECT_EQ(of_curve(0.65, 0.66, 0.70, 0.001), Finding::not_reproduced);
}

TEST(Doubt, TheModelOfTwoSamplesThatDifferStaysPossible) {
  Study study;
  study.mono = {point(1, 0, 0.3, {0.52, 0.60})};  // 0.56 +- 0.51
  const auto model = study.model(0.3);
  ASSERT_TRUE(model);
  EXPECT_LT(model->phi(0).low, 0.06);
  EXPECT_GT(model->phi(0).high, 0.99);
  EXPECT_LT(model->phi(0).high, 1);
  EXPECT_EQ(finding(study, "equal spheres, μ = 0.3"), Finding::not_reachable);
}

}  // namespace
}  // namespace furnas
