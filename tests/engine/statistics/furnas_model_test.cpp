#include "engine/statistics/furnas_model.h"

#include <gtest/gtest.h>

#include <limits>

#include "engine/base/require.h"

namespace furnas {
namespace {

constexpr double rounding = 1e-12;

TEST(FurnasModel, ItsMaximumIsThatOfTheStudy) {
  struct Row {
    double mono, f_max, phi_max;
  };
  // Without friction, with friction 0.3, and the usual round number; to the digits that the paper prints.
  for (const Row& row :
       {Row{0.638, 0.26579, 0.86896}, Row{0.588, 0.29178, 0.83026}, Row{0.64, 0.26471, 0.87040}}) {
    const FurnasModel model{row.mono};
    EXPECT_NEAR(model.f_max(), row.f_max, 5e-6);
    EXPECT_NEAR(model.phi_max(), row.phi_max, 5e-6);
    EXPECT_NEAR(model.f_max(), (1 - row.mono) / (2 - row.mono), rounding);
    EXPECT_NEAR(model.phi_max(), 1 - (1 - row.mono) * (1 - row.mono), rounding);
  }
}

TEST(FurnasModel, ItsBranchesMeetAtTheMaximum) {
  for (double mono = 0.05; mono < 1; mono += 0.05) {
    const FurnasModel model{mono};
    const double f = model.f_max();
    EXPECT_NEAR(mono / (1 - f), model.phi_max(), rounding);
    EXPECT_NEAR(mono / (f + mono * (1 - f)), model.phi_max(), rounding);
    EXPECT_NEAR(model.phi(f), model.phi_max(), rounding);
  }
}

TEST(FurnasModel, EachBranchHoldsOnItsSide) {
  const FurnasModel model{0.588};
  for (double share = 0; share < 1; share += 0.01) {
    const double below = share * model.f_max();
    EXPECT_NEAR(model.phi(below), 0.588 / (1 - below), rounding);
    const double above = 1 - share * (1 - model.f_max());
    EXPECT_NEAR(model.phi(above), 0.588 / (above + 0.588 * (1 - above)), rounding);
    EXPECT_LE(model.phi(below), model.phi_max() + rounding);
    EXPECT_LE(model.phi(above), model.phi_max() + rounding);
  }
}

TEST(FurnasModel, OneSizeAlonePacksAsItDoesAlone) {
  for (double mono : {0.588, 0.638}) {
    EXPECT_NEAR(FurnasModel{mono}.phi(0), mono, rounding);
    EXPECT_NEAR(FurnasModel{mono}.phi(1), mono, rounding);
  }
}

TEST(FurnasModel, TheFormingSizePacksAsItDoesAlone) {
  const FurnasModel model{0.638};
  for (double f = 0.01; f < 1; f += 0.01) {
    const double phi = model.phi(f);
    const double large = fraction_of_large(phi, f);
    const double small = fraction_in_voids(phi, f);
    EXPECT_NEAR(f < model.f_max() ? large : small, 0.638, rounding) << f;
    EXPECT_LT(f < model.f_max() ? small : large, 0.638) << f;
    EXPECT_NEAR(large + f * phi, phi, rounding);
    EXPECT_NEAR(small * (1 - large), f * phi, rounding);
  }
}

TEST(FurnasInterval, CarriesItsEndsThrough) {
  const FurnasInterval model(0.588, 0.004);
  const FurnasModel low{0.584}, high{0.592};
  EXPECT_EQ(model.f_max().value, model.middle().f_max());
  EXPECT_DOUBLE_EQ(model.f_max().low, high.f_max());  // it falls with phi_mono
  EXPECT_DOUBLE_EQ(model.f_max().high, low.f_max());
  EXPECT_DOUBLE_EQ(model.phi_max().low, low.phi_max());
  EXPECT_DOUBLE_EQ(model.phi_max().high, high.phi_max());
  for (double f = 0; f <= 1; f += 0.05) {
    const Interval phi = model.phi(f);
    EXPECT_DOUBLE_EQ(phi.low, low.phi(f));
    EXPECT_DOUBLE_EQ(phi.high, high.phi(f));
    EXPECT_LT(phi.low, phi.value);
    EXPECT_LT(phi.value, phi.high);
  }
}

TEST(FurnasInterval, OfASingleSampleHasNoWidth) {
  const FurnasInterval model(0.6, std::numeric_limits<double>::infinity());
  EXPECT_EQ(model.phi(0.2).low, model.phi(0.2).high);
}

TEST(FurnasInterval, StaysBetweenNothingAndAll) {
  EXPECT_THROW(FurnasInterval(0.6, 0.4), ContractError);
  EXPECT_THROW(FurnasInterval(0, 0), ContractError);
}

}  // namespace
}  // namespace furnas
