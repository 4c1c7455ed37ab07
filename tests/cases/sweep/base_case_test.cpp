#include "cases/program/sweep/base_case.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cases/program/sweep/thin_cells.h"
#include "tests/io/packings.h"

namespace furnas {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

SweepFile sweep_over(std::vector<std::string> larges) {
  SweepFile sweep;
  sweep.base.mixture.size_ratio = 3;
  sweep.base.mixture.small_fraction = 0.2;
  sweep.base.compaction.pressure = {2e-3};
  sweep.grids = {{{{"mixture.large", std::move(larges)}}, 2, "here"}};
  return sweep;
}

TEST(BaseCase, IsReadAsItWasWritten) {
  const SweepFile sweep = sweep_over({"40", "80"});
  const auto keys = keys_of(sweep);
  const TemporaryFolder folder;
  EXPECT_FALSE(read_base_case(folder / ""));
  write_file(folder / base_case_name, base_case_text(samples_of(sweep, keys, folder / ""), keys));
  const auto read = read_base_case(folder / "");
  ASSERT_TRUE(read);
  EXPECT_EQ(read->compaction.pressure, sweep.base.compaction.pressure);
  EXPECT_EQ(read->mixture.size_ratio, 3);
}

/// The sweep may be read on another machine than the one that it ran on.
TEST(BaseCase, IsReadWithoutTheFilesThatItNames) {
  const TemporaryFolder folder;
  write_file(folder / base_case_name, "[start]\nfile = \"gone.vtp\"\n[contact]\nfriction = 0.2\n");
  const auto read = read_base_case(folder / "");
  ASSERT_TRUE(read);
  EXPECT_EQ(read->contact.friction, 0.2);
}

TEST(BaseCase, KnowsWhatBearsOnPhi) {
  for (const char* key : {"compaction.pressure", "stop.criterion", "contact.law", "contact.friction",
                          "mixture.start_fraction", "compaction.cell_damping"})
    EXPECT_TRUE(bears_on_phi_J(*find_key(key))) << key;
  for (const char* key : {"mixture.seed", "stop.steps", "compute.threads", "compute.precision",
                          "output.history_every", "preset"})
    EXPECT_FALSE(bears_on_phi_J(*find_key(key))) << key;
}

TEST(ThinCells, OfAListOfDiametersAreMeasuredByTheLargest) {
  const TemporaryFolder folder;
  Case c;
  c.mixture.diameters = folder / "list.txt";
  write_file(c.mixture.diameters, "20\n40\n40\n");
  // 0.94 (pi/6 (1 + 8 + 8)/0.64)^(1/3)/2
  EXPECT_NEAR(thickness_in_diameters(c), 1.130, 1e-3);
  SweepFile sweep{c, {{{{"contact.friction", {"0.1", "0.3"}}}, 1, "here"}}};
  EXPECT_EQ(keys_of(sweep), std::vector<std::string>{"contact.friction"});
  EXPECT_THAT(remark_on_thin_cells(samples_of(sweep, keys_of(sweep), "")),
              HasSubstr("lists 10.8 times as long"));
}

TEST(ThinCells, AreToldWithTheNumberThatWouldDo) {
  const auto remark = [](std::vector<std::string> larges) {
    const SweepFile sweep = sweep_over(std::move(larges));
    return remark_on_thin_cells(samples_of(sweep, keys_of(sweep), ""));
  };
  EXPECT_THAT(remark({"100", "200"}), IsEmpty());
  EXPECT_THAT(remark({"10", "100"}), HasSubstr("at 1 of 2 points are too thin"));
  // 10 large spheres and 67 small: 0.94 (pi/6 (270 + 67)/0.64)^(1/3)/3 = 2.04 thick; (2.5/2.04)^3 times as
  // many make 2.5.
  EXPECT_THAT(remark({"10"}), testing::AllOf(HasSubstr("down to 2.0"), HasSubstr("mixture.large = 19")));
  Case c;
  c.mixture.size_ratio = 3;
  c.mixture.small_fraction = 0.2;
  c.mixture.large = 19;
  EXPECT_GE(thickness_in_diameters(c), 2.5);
  c.mixture.large = 18;
  EXPECT_LT(thickness_in_diameters(c), 2.5);
}

}  // namespace
}  // namespace furnas
