#include "cases/program/figures/gather.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cases/program/figures/study.h"
#include "cases/program/sweep/base_case.h"
#include "engine/base/require.h"
#include "tests/cases/sweep/made_rows.h"
#include "tests/io/packings.h"

namespace furnas {
namespace {

namespace fs = std::filesystem;

/// Two sweeps that differ in a key of [stop]; in the first, seed 1 has settled.
class TwoSweeps : public testing::Test {
 protected:
  TwoSweeps() {
    SampleTable first = paper_table();
    first.rows = {jammed_row("5.0", "0.3", "0.3", 1, 0.74), jammed_row("5.0", "0.3", "0.3", 2, 0.75)};
    first.rows[0].verdict = "settled";
    first.rows[0].phi_J = std::nan("");
    first.rows[0].phi_bound = 5e-4;
    SampleTable second = paper_table();
    second.rows = {jammed_row("5.0", "0.3", "0.3", 1, 0.7401)};
    second.rows[0].state_hash = "it went on";
    write("a", first, "phi_error = 1e-3");
    write("b", second, "phi_error = 0.0");
  }

  void write(const std::string& name, const SampleTable& table, const std::string& stop) const {
    fs::create_directories(folder_ / name);
    write_file(folder_ / name / sample_table_name, csv(table));
    write_file(folder_ / name / base_case_name, "[mixture]\nlarge = 100\n[stop]\n" + stop + "\n");
  }
  std::vector<fs::path> both() const { return {folder_ / "a", folder_ / "b"}; }
  SampleTable second() const { return read_sample_table(folder_ / "b"); }

 private:
  TemporaryFolder folder_;
};

TEST_F(TwoSweeps, StandTogetherIfOnlyTheLengthOfARunDiffers) {
  EXPECT_TRUE(gather(both()).varying().empty());
  EXPECT_NO_THROW(study_of(both()));
  write("b", second(), "force_imbalance = 1e-3");
  EXPECT_THROW(study_of(both()), InputError) << "another condition of rest";
}

TEST_F(TwoSweeps, MayDifferInTheMassesOfSpheresWithoutFriction) {
  const char* light = "phi_error = 1e-3\n[compaction]\nmass_exponent = 2.0";
  const SampleTable rough = second();
  write("b", rough, light);
  EXPECT_THROW(study_of(both()), InputError) << "with friction masses bear on phi_J";
  SampleTable smooth = paper_table();
  smooth.rows = {jammed_row("5.0", "0.3", "0.0", 1, 0.77), jammed_row("5.0", "0.3", "0.0", 2, 0.77)};
  write("b", smooth, light);
  const Study study = study_of(both());
  EXPECT_THAT(study.remarks,
              testing::ElementsAre("2 samples without friction were made with compaction.mass_exponent = 2"));
  write("c", smooth, "phi_error = 1e-3");
  std::vector<fs::path> all = both();
  all.push_back(all.front().parent_path() / "c");
  EXPECT_EQ(study_of(all).curve(5, 0)->points.front().jammed, 4u) << "solid and light spheres at one point";
  write("a", rough, light);
  EXPECT_THROW(study_of(all), InputError) << "light spheres with friction beside solid ones without";
}

TEST_F(TwoSweeps, MayComeFromAHigherPressureWithoutFriction) {
  const char* from_above = "phi_error = 1e-3\n[compaction]\npressure = [1e-3, 1e-4]";
  write("b", second(), from_above);
  EXPECT_THROW(study_of(both()), InputError) << "with friction the pressures before p_a bear on phi_J";
  SampleTable smooth = paper_table();
  smooth.rows = {jammed_row("5.0", "0.3", "0.0", 1, 0.77), jammed_row("5.0", "0.3", "0.0", 2, 0.77)};
  write("b", smooth, from_above);
  EXPECT_THAT(
      study_of(both()).remarks,
      testing::ElementsAre("2 samples without friction were made with compaction.pressure = [0.001;0.0001]"));
  write("b", smooth, "phi_error = 1e-3\n[compaction]\npressure = [1e-4, 1e-3]");
  EXPECT_THROW(study_of(both()), InputError) << "another p_a";
}

TEST_F(TwoSweeps, HaveARunThatWasCarriedOnOnce) {
  const Study study = study_of(both());
  ASSERT_EQ(study.points.size(), 1u);
  EXPECT_EQ(study.points[0].jammed, 2u);
  EXPECT_EQ(study.points[0].settled, 0u) << "seed 1 rests in the other folder";
  EXPECT_NEAR(study.points[0].mean_phi_J->mean, (0.75 + 0.7401) / 2, 1e-12);
}

}  // namespace
}  // namespace furnas
