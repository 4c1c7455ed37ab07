#include "cases/program/preflight.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "tests/cases/process.h"
#include "tests/cases/runs.h"

namespace furnas {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

Case bidisperse() {
  Case c;
  c.mixture.size_ratio = 4;
  c.mixture.small_fraction = 0.3;
  c.mixture.large = 100;
  return c;
}

TEST(Preflight, CountsTheSpheresAndTheirPairs) {
  const std::string report = check_case(bidisperse()).report;
  EXPECT_THAT(report, HasSubstr("particles 2843: 100 large of diameter 4, 2743 small of diameter 1"));
  EXPECT_THAT(report, HasSubstr("small-small  restitution 0.6669"));
  EXPECT_THAT(report, HasSubstr("small-large  restitution 0.56"));
  EXPECT_THAT(report, HasSubstr("large-large  restitution 0 (overdamped)"));
  const std::string mono = check_case({}).report;
  EXPECT_THAT(mono, HasSubstr("particles 1000: 1000 large of diameter 1, 0 small"));
  EXPECT_THAT(mono, HasSubstr("large-large  restitution 0.6669"));
  EXPECT_THAT(mono, Not(HasSubstr("small-")));
}

/// w dt of the stiffest pair: the tangential mode with friction, the normal one without.
TEST(Preflight, ComparesTheStepWithTheStiffestPair) {
  const double dt = 0.02 * std::numbers::pi / std::sqrt(12 / std::numbers::pi - 0.25 / 4);
  const std::string step = "time step 0.032415, 0.02 t_c (compaction.time_step), ";
  const double inverse_mass = 12 / std::numbers::pi;  // 1/m_eff of two small spheres
  const auto ratio = [](double x) { return std::to_string(x).substr(0, 4); };
  Case c;
  c.compaction.time_step = 0.02;
  EXPECT_THAT(check_case(c).report, HasSubstr(step + ratio(dt * std::sqrt(3.5 * inverse_mass))));
  c.contact.friction = 0;
  EXPECT_THAT(check_case(c).report, HasSubstr(step + ratio(dt * std::sqrt(inverse_mass))));
}

TEST(Preflight, SaysWhatChoseTheStep) {
  Case c;
  EXPECT_THAT(check_case(c).report, HasSubstr("0.0633 t_c (auto: the rule for a small sphere that sticks"));
  c.contact.friction = 0;
  EXPECT_THAT(check_case(c).report, HasSubstr("0.1 t_c (auto: a tenth of a collision"));
  c.compaction.time_step_absolute = 0.05;
  EXPECT_THAT(check_case(c).report, HasSubstr("time step 0.05, 0.0308 t_c (compaction.time_step_absolute)"));
}

TEST(Preflight, RemarksOnACellOfFewLargeSpheres) {
  const char* const thin = "too thin to represent a large packing";
  const char* const images = "spheres touch several images of each other";
  Case c;
  c.mixture.large = 5;
  EXPECT_THAT(check_case(c).report, AllOf(HasSubstr(thin), HasSubstr(images)));
  c.mixture.large = 20;
  EXPECT_THAT(check_case(c).report, AllOf(HasSubstr(thin), Not(HasSubstr(images))));
  EXPECT_TRUE(check_case(c).refusal.empty());
  c.mixture.large = 100;
  EXPECT_THAT(check_case(c).report, AllOf(Not(HasSubstr(thin)), Not(HasSubstr(images))));
}

TEST(Preflight, SaysThatSpheresOfOneSizeAreAllEqual) {
  const char* const equal = "all equal: with a size ratio of 1 large and small differ in name alone";
  Case c;
  EXPECT_THAT(check_case(c).report, Not(HasSubstr(equal)));
  c.mixture.small_fraction = 0.3;
  EXPECT_THAT(check_case(c).report, HasSubstr(equal));
  c.mixture.size_ratio = 2;
  EXPECT_THAT(check_case(c).report, Not(HasSubstr(equal)));
  EXPECT_EQ(check_case(c).remark, "");
  c.mixture.small_fraction = 0;
  EXPECT_THAT(check_case(c).remark, HasSubstr("size_ratio = 2 has no effect"));
  EXPECT_THAT(check_case(c).report, HasSubstr("note      mixture.size_ratio = 2 has no effect"));
}

TEST(Preflight, RefusesWhatTheMachineCannotHold) {
  Case c = bidisperse();
  EXPECT_TRUE(check_case(c).refusal.empty());
  c.mixture.size_ratio = 100;
  c.mixture.small_fraction = 0.5;
  c.mixture.large = 2000;
  const std::string refusal = check_case(c).refusal;  // 2e9 spheres
  EXPECT_THAT(refusal, HasSubstr(" GB"));
  EXPECT_THAT(refusal, HasSubstr("take fewer particles (mixture.large = "));

  const TemporaryFolder folder;
  Case listed;
  listed.mixture.diameters = folder / "list.txt";
  std::string diameters;
  for (int k = 0; k < 2000; ++k) diameters += "1\n";
  write_file(listed.mixture.diameters, diameters);
  listed.output.picture = "none";
  EXPECT_THAT(check_case(listed, {1e6, "a limit allows"}).refusal,
              HasSubstr("take a shorter list of diameters"));
}

/// A control group or ulimit that allows less than the machine has counts.
TEST(ReliablePreflight, RefusesWhatALimitForbids) {
  const Case c = bidisperse();
  EXPECT_TRUE(check_case(c, {10 * expected_memory(1e4, c), "this machine has"}).refusal.empty());
  EXPECT_THAT(check_case(c, {1e6, "its control group allows"}).refusal,
              HasSubstr("its control group allows 0.0 GB; take a larger machine"));
  EXPECT_THAT(check_case(c, {1e8, "ulimit allows"}).refusal,
              HasSubstr("0.5 GB and ulimit allows 0.1 GB; take no picture (output.picture = \"none\")"));
}

/// The value behind `key` in a refusal.
std::int64_t advised(const Case& c, const MemoryLimit& limit, const std::string& key) {
  const std::string refusal = check_case(c, limit).refusal;
  const auto at = refusal.find(key + " = ");
  return at == refusal.npos ? -1 : std::stoll(refusal.substr(at + key.size() + 3));
}

TEST(ReliablePreflight, AdvisesTheLargestThatFits) {
  Case c = bidisperse();
  const MemoryLimit small{2e8, "ulimit allows"};
  const std::int64_t edge = advised(c, small, "output.picture_size");
  ASSERT_GT(edge, 0);
  c.output.picture_size = static_cast<int>(edge);
  EXPECT_EQ(check_case(c, small).refusal, "");
  ++c.output.picture_size;
  EXPECT_NE(check_case(c, small).refusal, "");

  c.output.picture = "none";
  c.mixture.large = 1'000'000;
  const std::int64_t large = advised(c, small, "mixture.large");
  ASSERT_GT(large, 0);
  c.mixture.large = large;
  EXPECT_EQ(check_case(c, small).refusal, "");
  c.mixture.large += large / 1000 + 2;  // small spheres are whole numbers
  EXPECT_NE(check_case(c, small).refusal, "");
}

TEST(ReliablePreflight, RefusesWhatNeverComesToRest) {
  Case c;
  c.contact.normal_damping = 0;
  c.compaction.drag = 0;
  EXPECT_TRUE(check_case(c).refusal.empty()) << "friction takes energy out";
  c.contact.friction = 0;
  EXPECT_THAT(check_case(c).refusal,
              HasSubstr("contact.normal_damping, contact.friction and compaction.drag are 0"));
  c.compaction.drag = 0.1;
  EXPECT_TRUE(check_case(c).refusal.empty());
  c.compaction.drag = 0.0;
  c.compaction.cell = "fixed";
  EXPECT_TRUE(check_case(c).refusal.empty());
}

TEST(ReliablePreflight, RefusesWhatNobodyLivesToSee) {
  Case c;
  c.mixture.large = 100'000'000;
  c.compute.threads = 1;
  c.stop.window = 1e9;
  c.stop.steps = 1'000'000'000'000;
  EXPECT_THAT(check_case(c, {1e15, "this machine has"}).refusal, HasSubstr("stop.window = 1000000000 t_c"));
  c.stop.window = 200;
  EXPECT_TRUE(check_case(c, {1e15, "this machine has"}).refusal.empty());
}

TEST(ReliablePreflight, SaysWhenStepsDoNotSuffice) {
  Case c;
  EXPECT_THAT(check_case(c).report, Not(HasSubstr("verdict")));
  c.stop.steps = 5'000;
  EXPECT_THAT(check_case(c).report, Not(HasSubstr("verdict")));
  c.compaction.pressure = {1e-4, 2e-4};
  EXPECT_THAT(check_case(c).report, HasSubstr("verdict   none: 2 windows of 200 t_c do not fit"));
}

/// Counts beyond 2^31 and 2^32, in which every product with the bytes of a sphere is beyond both.
TEST(Preflight, CountsAnyNumberOfSpheres) {
  Case c;
  c.mixture.size_ratio = 40;
  c.mixture.small_fraction = 0.292;
  EXPECT_THAT(check_case(c).report, HasSubstr("particles 26396480: 1000 large"));  // the paper's largest
  EXPECT_THAT(check_case(c).report, HasSubstr("memory    about 19.75 GB"));
  c.mixture.large = 10'000'000;
  c.mixture.size_ratio = 100;
  c.mixture.small_fraction = 0.75;
  const Preflight largest = check_case(c);
  EXPECT_THAT(largest.report, HasSubstr("particles 30000010000000: 10000000 large"));
  EXPECT_THAT(largest.report, HasSubstr("memory    about 22402097.33 GB"));
  EXPECT_THAT(largest.refusal, HasSubstr("take fewer particles (mixture.large = "));
}

TEST(Preflight, MemoryGrowsWithTheSpheres) {
  Case c;
  c.output.picture = "none";
  EXPECT_GT(expected_memory(0, c), 0);
  EXPECT_NEAR(expected_memory(3e6, c) - expected_memory(2e6, c),
              expected_memory(2e6, c) - expected_memory(1e6, c), 1);
  Case drawn = c;
  drawn.output.picture = "fig1a";
  EXPECT_GT(expected_memory(1e4, drawn), expected_memory(1e4, c));
  EXPECT_EQ(expected_memory(1e8, drawn), expected_memory(1e8, c)) << "the files need more than the picture";
  c.compute.precision = "double";
  EXPECT_GT(expected_memory(1e8, c), expected_memory(1e8, drawn));
}

/// What `check` foretells is what the process holds at its peak.
TEST(ReliablePreflight, ForetellsTheMemoryOfARun) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the sanitizer needs more";
#endif
  const Runs runs;
  ASSERT_EQ(runs.run("small").code, ExitCode::done);
  ASSERT_EQ(furnas({"replicate", runs.path("small"), runs.path("large.checkpoint"), "--times", "8x8x8"}).code,
            ExitCode::done);
  write_file(runs.path("large.toml"),
             "[start]\nfile = \"large.checkpoint\"\n[stop]\nsteps = 10\n[output]\npicture = \"none\"\n");
  const Ending ending = ending_of({"run", runs.path("large.toml"), "--out", runs.path("large")});
  ASSERT_EQ(ending.code, 5) << ending.out;
  Case c;
  c.output.picture = "none";
  const double foretold = expected_memory(51'200, c);
  EXPECT_NEAR(ending.peak, foretold, 0.1 * foretold);
}

}  // namespace
}  // namespace furnas
