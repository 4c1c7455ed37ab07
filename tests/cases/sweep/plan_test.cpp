#include "cases/program/sweep/plan.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "cases/program/build_info.h"
#include "cases/program/sweep/sample_table.h"
#include "engine/base/require.h"
#include "io/case_file.h"
#include "tests/io/packings.h"

namespace furnas {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr const char* mixture_sweep = R"([mixture]
size_ratio = 2.0
large = 20
[[sweep]]
"mixture.small_fraction" = [0.1, 0.3]
"contact.friction" = [0.0, 0.3]
samples = 3
[[sweep]]
"mixture.size_ratio" = 3
"mixture.small_fraction" = 0.2
)";

class Plans : public testing::Test {
 protected:
  SweepFile sweep(const std::string& text) const {
    write_file(folder_ / "a.toml", text);
    return read_sweep(folder_ / "a.toml");
  }
  fs::path path(const std::string& name) const { return folder_ / name; }

 private:
  TemporaryFolder folder_;
};

/// Medians of docs/results/performance.md, "Steps to a verdict", and of docs/results/study; an evaluation of
/// the minimizer counts as one and a half steps.
TEST_F(Plans, ForetellTheStepsOfASampleWithinAFactorOfThree) {
  struct Measured {
    const char *size_ratio, *small_fraction, *friction, *large;
    double steps;
  };
  for (const Measured& m : {Measured{"1.0", "0.0", "0.3", "1000", 20'900},
                            {"1.0", "0.0", "0.0", "1000", 62'500},
                            {"2.0", "0.2", "0.3", "100", 30'000},
                            {"5.0", "0.2", "0.3", "100", 89'700},
                            {"5.0", "0.3", "0.3", "100", 320'000},
                            {"5.0", "0.35", "0.3", "100", 517'000},
                            {"5.0", "0.3", "0.0", "100", 172'000},
                            {"10.0", "0.3", "0.3", "30", 201'000},
                            {"20.0", "0.29", "0.3", "20", 312'000}}) {
    const SweepFile file =
        sweep(fmt::format("[mixture]\nsize_ratio = {}\nsmall_fraction = {}\nlarge = {}\n[contact]\nfriction "
                          "= {}\n[sweep]\nsamples = 1\n",
                          m.size_ratio, m.small_fraction, m.large, m.friction));
    const double steps = samples_of(file, keys_of(file), "s").at(0).steps;
    EXPECT_GT(steps, m.steps / 3) << m.size_ratio << ' ' << m.small_fraction << ' ' << m.friction;
    EXPECT_LT(steps, m.steps * 3) << m.size_ratio << ' ' << m.small_fraction << ' ' << m.friction;
  }
}

TEST_F(Plans, IsTheGridTimesTheSeeds) {
  const SweepFile file = sweep(mixture_sweep);
  const auto keys = keys_of(file);
  EXPECT_THAT(keys, ElementsAre("mixture.size_ratio", "mixture.small_fraction", "contact.friction"));
  const auto samples = samples_of(file, keys, "s");
  ASSERT_EQ(samples.size(), 2u * 2 * 3 + 1);
  EXPECT_EQ(samples[0].resolved_case.mixture.seed, 1);
  EXPECT_EQ(samples[2].resolved_case.mixture.seed, 3);
  EXPECT_EQ(samples.back().resolved_case.mixture.size_ratio, 3);
  EXPECT_EQ(samples.back().folder, "s/samples/size_ratio=3.0,small_fraction=0.2,friction=0.3/1");
  EXPECT_EQ(samples[0].particles, 20 + 18);  // 20 * 8 * 0.1/0.9
  std::set<fs::path> folders;
  for (const Sample& sample : samples) folders.insert(sample.folder);
  EXPECT_EQ(folders.size(), samples.size());
}

TEST_F(Plans, KnowsWhichKeysVary) {
  EXPECT_THAT(
      keys_of(sweep("[sweep]\n\"compaction.pressure\" = [1e-3, 1e-4]\n\"stop.steps\" = 5")),
      ElementsAre("mixture.size_ratio", "mixture.small_fraction", "contact.friction", "compaction.pressure"));
}

TEST_F(Plans, LargerSamplesAndManySpheresWithoutFrictionCostMore) {
  const auto cost = [](double size_ratio, double friction) {
    Case c;
    c.mixture = {size_ratio, 0.2, 1000, 0.05, 1};
    c.contact.friction = friction;
    return sample_of(c, {}, "s").cost();
  };
  EXPECT_LT(cost(2, 0.3), cost(3, 0.3));
  EXPECT_LT(cost(2, 0.3), cost(2, 0));
}

TEST_F(Plans, RefusesCombinationsThatAreNoCase) {
  const SweepFile file = sweep("[mixture]\nlarge = 10\n[sweep]\n\"mixture.small_fraction\" = [0.0, 0.01]");
  try {
    samples_of(file, keys_of(file), "s");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("a.toml:3: "));
    EXPECT_THAT(error.what(), HasSubstr("small_fraction = 0.01"));
  }
}

TEST_F(Plans, RefusesSeedsOfAStartThatHasNone) {
  write_file(path("a.extxyz"), "");
  const SweepFile file = sweep("[start]\nfile = \"a.extxyz\"\n[sweep]\nsamples = 2");
  try {
    samples_of(file, keys_of(file), "s");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("a.toml:3: samples = 2, but start.file"));
  }
}

TEST_F(Plans, ASampleIsKnownByItsCase) {
  Case c;
  const Sample sample = sample_of(c, {"contact.friction"}, path(""));
  EXPECT_EQ(state_of(sample), SampleState::missing);
  const auto resolve = [&](const Case& other) {
    write_file(sample.folder / "case.resolved.toml", resolved_toml(other));
  };
  fs::create_directories(sample.folder);
  c.compute.threads = 3;  // changes no bit
  resolve(c);
  EXPECT_EQ(state_of(sample), SampleState::missing);
  const auto end = [&](const std::string& verdict, std::int64_t steps) {
    const nlohmann::json result{{"verdict", verdict}, {"steps", steps}, {"version", build_info().version}};
    write_file(sample.folder / "result.json", result.dump());
  };
  end("jammed", 5);
  EXPECT_EQ(state_of(sample), SampleState::finished);
  end("budget", 10'000'000);
  EXPECT_EQ(state_of(sample), SampleState::finished);
  end("budget", 9'999'999);
  EXPECT_EQ(state_of(sample), SampleState::missing) << "its steps are not spent, but it has no checkpoint";
  write_file(sample.folder / "result.json", "damaged");
  EXPECT_EQ(state_of(sample), SampleState::missing);
  c.contact.normal_damping = 0.1;
  resolve(c);
  EXPECT_THROW(state_of(sample), InputError);
}

TEST_F(Plans, SamplesOfAnotherVersionAreRefused) {
  const Sample sample = sample_of(Case{}, {"contact.friction"}, path(""));
  fs::create_directories(sample.folder);
  write_file(sample.folder / "case.resolved.toml", resolved_toml(sample.resolved_case));
  for (const char* result : {R"({"verdict": "jammed", "steps": 5, "version": "0.0.1"})",
                             R"({"verdict": "jammed"})", R"({"version": null})", R"({"version": 3})"}) {
    write_file(sample.folder / "result.json", result);
    EXPECT_THROW(state_of(sample), InputError) << result;
  }
}

TEST_F(Plans, ADamagedResultIsNamed) {
  const Sample sample = sample_of(Case{}, {"contact.friction"}, path(""));
  fs::create_directories(sample.folder);
  write_file(sample.folder / "case.resolved.toml", resolved_toml(sample.resolved_case));
  const std::string version = fmt::format(R"("version": "{}")", build_info().version);
  for (const std::string& result :
       {std::string("{"), "{" + version + R"(, "large": 100})",
        "{" + version +
            R"(, "large": 1, "small": 0, "verdict": "jammed", "reason": "", "phi_J": 0.6, "phi": 0.6,
            "Z": 4, "Z_backbone": 4, "backbone_threshold": 2,
            "rattlers": [{"least_contacts": 9, "large": 0, "small": 0, "backbone": 1}]})"}) {
    write_file(sample.folder / "result.json", result);
    try {
      table_of({sample}, {"contact.friction"});
      ADD_FAILURE() << result;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), testing::HasSubstr("result.json")) << result;
    }
  }
}

TEST_F(Plans, FindsWhatRefinementHasAdded) {
  const SweepFile file = sweep(mixture_sweep);
  const auto keys = keys_of(file);
  const auto planned = samples_of(file, keys, path(""));
  EXPECT_TRUE(added_samples(planned, keys, path("")).empty());
  const Sample added = moved_to(planned[0], 0.15, keys, path(""));
  Sample foreign = moved_to(planned[0], 0.25, keys, path(""));
  foreign.resolved_case.contact.normal_damping = 0.1;
  Case other = planned[0].resolved_case;  // of a value that the file has no more
  other.contact.friction = 0.7;
  for (const Sample& sample : {planned[0], added, foreign, sample_of(other, keys, path(""))}) {
    fs::create_directories(sample.folder);
    write_file(sample.folder / "case.resolved.toml", resolved_toml(sample.resolved_case));
  }
  write_file(path("samples") / ".DS_Store", "a file of the user's desktop");
  EXPECT_EQ(resolved_cases_in(path("")).size(), 4u);
  const auto found = added_samples(planned, keys, path(""));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].folder, added.folder);
  EXPECT_EQ(found[0].values, added.values);
}

}  // namespace
}  // namespace furnas
