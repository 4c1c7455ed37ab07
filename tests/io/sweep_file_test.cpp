#include "io/sweep_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/base/require.h"
#include "io/atomic_file.h"
#include "io/case_file.h"
#include "tests/io/packings.h"

namespace furnas {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

class SweepFiles : public testing::Test {
 protected:
  std::filesystem::path write(const std::string& text) const {
    write_file(folder_ / "a.toml", text);
    return folder_ / "a.toml";
  }
  /// What reading it complains of.
  std::string complaint(const std::string& text) const {
    try {
      read_sweep(write(text));
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }

 private:
  TemporaryFolder folder_;
};

TEST_F(SweepFiles, HasAxesAndSamples) {
  const auto file = write(
      "[mixture]\nlarge = 50\n[sweep]\n\"contact.friction\" = [0, 0.3]\n\"mixture.size_ratio\" = 5\n"
      "\"compaction.pressure\" = [1e-3, [1e-3, 1e-4]]\nsamples = 4\n");
  EXPECT_TRUE(holds_sweep(file));
  const SweepFile sweep = read_sweep(file, std::vector<std::string>{"stop.steps=7"});
  EXPECT_EQ(sweep.base.mixture.large, 50);
  EXPECT_EQ(sweep.base.stop.steps, 7);
  ASSERT_EQ(sweep.grids.size(), 1u);
  const SweepGrid& grid = sweep.grids.front();
  EXPECT_EQ(grid.samples, 4);
  EXPECT_THAT(grid.place, HasSubstr("a.toml:3"));
  ASSERT_EQ(grid.axes.size(), 3u);
  for (const SweepAxis& axis : grid.axes) {
    Case c;
    for (const std::string& value : axis.values) EXPECT_NO_THROW(apply_override(c, axis.key + "=" + value));
    if (axis.key == "contact.friction") {
      EXPECT_EQ(axis.values.size(), 2u);
    }
    if (axis.key == "mixture.size_ratio") {
      EXPECT_EQ(axis.values.size(), 1u);
    }
    if (axis.key == "compaction.pressure") {
      EXPECT_THAT(c.compaction.pressure, ElementsAre(1e-3, 1e-4));
    }
  }
}

TEST_F(SweepFiles, MayHaveSeveralGrids) {
  const SweepFile sweep = read_sweep(
      write("[[sweep]]\n\"contact.friction\" = [0.0]\n[[sweep]]\n\"contact.friction\" = [0.1]\nsamples = 2"));
  ASSERT_EQ(sweep.grids.size(), 2u);
  EXPECT_EQ(sweep.grids[0].samples, 1);
  EXPECT_EQ(sweep.grids[1].samples, 2);
}

TEST_F(SweepFiles, NamesWhatIsWrong) {
  EXPECT_THAT(complaint("[sweep]\n\"contact.friction\" = [0.1, -1.0]"),
              AllOf(HasSubstr("a.toml:2"), HasSubstr("contact.friction = -1"), HasSubstr("allowed: 0 <=")));
  EXPECT_THAT(complaint("[sweep]\n\"contact.frictoin\" = [0.1]"),
              AllOf(HasSubstr("a.toml:2"), HasSubstr("contact.frictoin"), HasSubstr("\"contact.friction\"")));
  EXPECT_THAT(complaint("[sweep]\n\"contact.friction\" = []"), HasSubstr("no value"));
  EXPECT_THAT(complaint("[sweep]\n\"contact.friction\" = [\"much\"]"), HasSubstr("a.toml:2"));
  EXPECT_THAT(complaint("[sweep]\n\"mixture.seed\" = [1, 2]"), HasSubstr("allowed: samples"));
  for (const char* samples : {"0", "-1", "2.5", "\"two\"", "1000000"})
    EXPECT_THAT(complaint(std::string("[sweep]\nsamples = ") + samples),
                AllOf(HasSubstr("a.toml:2: sweep.samples"), HasSubstr("allowed: an integer from 1")));
  EXPECT_THAT(complaint("sweep = 3"), HasSubstr("a.toml:1"));
  EXPECT_THAT(complaint("[mixture]\nlarge = 3"), HasSubstr("no [sweep]"));
  EXPECT_THAT(complaint("[sweep\n"), HasSubstr("a.toml:1"));
}

TEST_F(SweepFiles, RefuseAssignmentsThatChangeNothing) {
  const std::vector<std::string> set{"contact.friction=0.2"};
  const auto read = [&](const char* text) { read_sweep(write(text), set); };
  EXPECT_NO_THROW(read("[sweep]\n\"mixture.large\" = [5, 6]"));
  EXPECT_NO_THROW(read("[[sweep]]\n\"contact.friction\" = 0.1\n[[sweep]]\nsamples = 2"));
  try {
    read("[[sweep]]\n\"contact.friction\" = 0.1\n[[sweep]]\n\"contact.friction\" = 0.3");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(),
                AllOf(HasSubstr("--set contact.friction=0.2"), HasSubstr("a.toml:1"), HasSubstr("allowed:")));
  }
}

TEST_F(SweepFiles, AreNoCases) {
  const auto file = write("[sweep]\nsamples = 2\n");
  try {
    read_case(file);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("a.toml:1"), HasSubstr("furnas sweep")));
  }
  EXPECT_THROW(parse_case("[[sweep]]\nsamples = 2", "a"), InputError);
  EXPECT_FALSE(holds_sweep(write("[mixture]\nlarge = 3")));
}

}  // namespace
}  // namespace furnas
