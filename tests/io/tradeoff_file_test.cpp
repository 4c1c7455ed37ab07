#include "io/tradeoff_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/base/require.h"
#include "tests/io/packings.h"

namespace furnas {
namespace {

using testing::HasSubstr;

constexpr const char* two_cases = R"([mixture]
large = 50
[tradeoff]
samples = 3
margin = 2e-3
reference = "careful"
[cases.smooth]
"contact.friction" = 0.0
[cases.rough]
"contact.friction" = 0.5
samples = 4
reference = "plain"
[arms.plain]
[arms.careful]
"preset" = "reference"
[arms."pressure_1e-3"]
"compaction.pressure" = 1e-3
[arms.stairs]
"compaction.pressure" = [1e-3, 1e-4]
cases = ["smooth"]
)";

class TradeoffFiles : public testing::Test {
 protected:
  TradeoffFile read(const std::string& text) const {
    write_file(folder_ / "t.toml", text);
    return read_tradeoff(folder_ / "t.toml");
  }
  std::string complaint(const std::string& text) const {
    try {
      read(text);
    } catch (const InputError& error) {
      return error.what();
    }
    return "nothing";
  }

 private:
  TemporaryFolder folder_;
};

TEST_F(TradeoffFiles, CrossCasesWithArms) {
  const TradeoffFile file = read(two_cases);
  ASSERT_EQ(file.cases.size(), 2u);
  const TradeoffCase &smooth = file.cases[0], &rough = file.cases[1];
  EXPECT_EQ(smooth.name, "smooth");
  EXPECT_EQ(smooth.samples, 3);
  EXPECT_EQ(smooth.margin, 2e-3);
  EXPECT_EQ(smooth.reference, "careful");
  EXPECT_EQ(rough.samples, 4);
  EXPECT_EQ(rough.reference, "plain");
  ASSERT_EQ(smooth.arms.size(), 4u);
  ASSERT_EQ(rough.arms.size(), 3u) << "stairs are for smooth alone";
  for (const TradeoffArm& arm : rough.arms) {
    EXPECT_EQ(arm.c.mixture.large, 50);
    EXPECT_EQ(arm.c.contact.friction, 0.5);
  }
  EXPECT_EQ(rough.arms[1].c.compute.precision, "double") << "a value of the preset";
  EXPECT_EQ(rough.arms[1].c.compaction.time_step, 0.02);
  EXPECT_EQ(rough.arms[2].c.compaction.pressure, std::vector<double>{1e-3});
  EXPECT_TRUE(rough.arms[2].pressure_alone);
  EXPECT_FALSE(rough.arms[0].pressure_alone);
  EXPECT_FALSE(smooth.arms[3].pressure_alone) << "stairs have no one pressure";
}

TEST_F(TradeoffFiles, SayWhatIsWrong) {
  const std::string text = two_cases;
  const auto with = [&](const std::string& more) { return complaint(text + more); };
  EXPECT_THAT(complaint("[mixture]\nlarge = 5\n"), HasSubstr("no [tradeoff]"));
  EXPECT_THAT(with("[[sweep]]\n\"contact.friction\" = [0.1]\n"),
              HasSubstr("[sweep] has no effect in a tradeoff"));
  EXPECT_THAT(with("[arms.a]\n\"contact.frict\" = 1.0\n"), HasSubstr("\"contact.friction\""));
  EXPECT_THAT(with("[arms.a]\n\"contact.friction\" = -1.0\n"), HasSubstr("0 <= friction"));
  EXPECT_THAT(with("[arms.a]\n\"mixture.seed\" = 4\n"), HasSubstr("seeds are taken from the samples"));
  EXPECT_THAT(with("[arms.a]\ncases = [\"rugged\"]\n"), HasSubstr("allowed: \"smooth\", \"rough\""));
  EXPECT_THAT(with("[arms.again]\n"), HasSubstr("arms.plain and arms.again are one and the same case"));
  EXPECT_THAT(with("[arms.\"a/b\"]\n"), HasSubstr("not a name for a folder"));
  EXPECT_THAT(with("[cases.c]\nmargin = 2.0\n"), HasSubstr("0 < margin < 1"));
  EXPECT_THAT(with("[cases.c]\nreference = \"none\"\n"), HasSubstr("is no arm of cases.c"));
  EXPECT_THAT(complaint("[tradeoff]\nsample = 3\n"), HasSubstr("unknown key tradeoff.sample"));
  EXPECT_THAT(complaint("[tradeoff]\nsamples = 3\nmargin = 0.1\n[cases.a]\n[arms.b]\n"),
              HasSubstr("cases.a has no reference"));
}

}  // namespace
}  // namespace furnas
