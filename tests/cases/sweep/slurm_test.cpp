#include "cases/program/sweep/slurm.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cases/program/preflight.h"
#include "tests/cases/process.h"
#include "tests/cases/runs.h"

namespace furnas {
namespace {

namespace fs = std::filesystem;
using std::chrono::minutes;
using testing::HasSubstr;

/// Samples that take so many seconds of a core each.
std::vector<Sample> samples_of_seconds(std::size_t count, double seconds) {
  Sample sample;
  sample.particles = 1000;
  sample.steps = seconds * pace_of_a_core / sample.particles;
  return std::vector<Sample>(count, sample);
}

TEST(SlurmArrays, HaveTimeAndTasksForTwiceWhatIsForetold) {
  const SlurmArray small = array_for(samples_of_seconds(3, 10), {});
  EXPECT_EQ(small.cores, 3);
  EXPECT_EQ(small.tasks, 1);
  EXPECT_EQ(small.time, minutes(10)) << "not less";
  const SlurmArray large = array_for(samples_of_seconds(320, 3600), {});
  EXPECT_EQ(large.cores, 16);
  EXPECT_EQ(large.time, minutes(120));
  EXPECT_EQ(large.tasks, 20) << "a core for each sample at most";
  EXPECT_NEAR(large.memory, 16 * 1.2 * samples_of_seconds(1, 1)[0].memory(), 2e8);
  const SlurmArray told = array_for(samples_of_seconds(320, 3600), {.cores = 8, .walltime = minutes(600)});
  EXPECT_EQ(told.cores, 8);
  EXPECT_EQ(told.time, minutes(600));
  EXPECT_EQ(told.tasks, 8) << "320 h, twice, over 80 h a task";
}

TEST(SlurmArrays, NeedTimeToSave) {
  EXPECT_THROW(array_for(samples_of_seconds(1, 1), {.walltime = minutes(1)}), InputError);
  EXPECT_EQ(array_for(samples_of_seconds(1, 1), {.walltime = minutes(2)}).time, minutes(2));
}

TEST(SlurmScripts, CallTheWorkerWithLessTimeThanTheTask) {
  SlurmArray array{.tasks = 5, .cores = 8, .memory = 3.5e9, .time = minutes(240)};
  const std::string text =
      slurm_script(array, {.partition = "long"}, {"/bin/furnas", "sweep", "/a b.toml"}, "/out");
  EXPECT_THAT(text, testing::StartsWith("#!/bin/bash\n"));
  for (const char* line :
       {"#SBATCH --array=1-5\n", "#SBATCH --partition=long\n", "#SBATCH --time=240\n",
        "#SBATCH --cpus-per-task=8\n", "#SBATCH --mem=3500M\n", "\n/bin/furnas sweep '/a b.toml' ",
        "--walltime 235m --leave\n", "scontrol requeue"})
    EXPECT_THAT(text, HasSubstr(line));
  EXPECT_THAT(slurm_script(array, {}, {"furnas"}, "/out"), testing::Not(HasSubstr("partition")));
}

// Slurm replaces % and a letter in the name of the output, and ends a name at its quote.
TEST(SlurmScripts, NamesOfFoldersMayHaveAnyLetter) {
  const std::string text = slurm_script({}, {}, {"furnas"}, "/5%A \"b\"");
  EXPECT_THAT(text, HasSubstr("#SBATCH --output=\"/5%%A \\\"b\\\"/slurm-%A_%a.out\"\n"));
}

TEST(SlurmScripts, AreWrittenWithTheCommandThatSubmitsThem) {
  const Runs runs("[mixture]\nlarge = 100\n[sweep]\nsamples = 4\n");
  const Ending answer =
      ending_of({"sweep", runs.path("case.toml"), "--out", runs.path("out"), "--slurm", "--samples", "3"});
  ASSERT_EQ(answer.code, 0) << answer.out;
  EXPECT_THAT(answer.out, HasSubstr("submit   sbatch " + runs.path("out/sweep.sbatch")));
  EXPECT_THAT(answer.out, HasSubstr("1 task of 3 cores"));
  const std::string script = content(runs.path("out/sweep.sbatch"));
  EXPECT_THAT(script,
              HasSubstr(" sweep " + runs.path("case.toml") + " --out " + runs.path("out") + " --samples 3 "));
  EXPECT_FALSE(fs::exists(runs.path("out/samples"))) << "nothing is run";
}

// A task may start in another folder.
TEST(SlurmScripts, NameFilesOfTheCommandLineByTheirWholePath) {
  const Runs runs("[contact]\nfriction = 0.3\n");
  write_file(runs.path("sizes.txt"), "1\n1.5\n2\n");
  const std::string relative = fs::relative(runs.path("sizes.txt")).string();
  const Ending answer = ending_of({"sweep", runs.path("case.toml"), "--out", runs.path("out"), "--slurm",
                                   "--samples", "2", "--set", "mixture.diameters = \"" + relative + "\""});
  ASSERT_EQ(answer.code, 0) << answer.out;
  EXPECT_THAT(content(runs.path("out/sweep.sbatch")),
              HasSubstr("mixture.diameters=" + runs.path("sizes.txt")));
}

}  // namespace
}  // namespace furnas
