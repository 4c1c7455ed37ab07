#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "cases/program/run/recording.h"
#include "engine/state/fingerprint.h"
#include "io/formats.h"
#include "tests/cases/runs.h"
#include "tests/engine/support/release_machine.h"

namespace furnas {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;
using Json = nlohmann::json;

/// The packing of the newest checkpoint.
Packing saved(const Runs& runs, const std::string& name) {
  return Checkpoints::read_newest(runs.path(name)).packing;
}

TEST(Run, JamsAFewSpheres) {
  const Runs runs;
  const Answer answer = runs.run("a", {"mixture.large=200"});
  ASSERT_EQ(answer.code, ExitCode::done) << answer.err;
  const Json result = runs.result("a");
  EXPECT_EQ(result["verdict"], "jammed");
  EXPECT_GT(result["phi_J"], 0.55);
  EXPECT_LT(result["phi_J"], 0.62);
  EXPECT_EQ(result["phi_J"], result["phi"]);
  EXPECT_GT(result["Z_backbone"], 4);
  EXPECT_LT(result["stress_error"], 1e-2);
  EXPECT_LT(result["force_imbalance"], 1e-2);
  EXPECT_EQ(result["resting_states"].size(), 1u);
  EXPECT_EQ(result["state_hash"], hex(state_hash(saved(runs, "a"))));
  EXPECT_THAT(answer.out, HasSubstr("verdict   jammed"));
  EXPECT_THAT(answer.out, HasSubstr("phi_J"));
  EXPECT_THAT(answer.out, HasSubstr(" largest diameters thick\n"));
  EXPECT_EQ(content(runs.path("a/log.txt")), answer.out);
}

TEST(Run, SaysThatAFewLargeSpheresAreTooFew) {
  const Runs runs;
  const Answer answer = runs.run("a", {"mixture.size_ratio=4", "mixture.small_fraction=0.5",
                                       "mixture.large=2", "stop.steps=10", "mixture.start_fraction=0.2"});
  EXPECT_THAT(answer.out, HasSubstr("diameters thick: too thin to represent a large packing\n"));
  EXPECT_LT(runs.result("a")["thickness_in_largest_diameters"], 2.5);
}

TEST(Run, KeepsTheUnitOfAListOfDiameters) {
  std::string text = Runs::soft_case;
  text.erase(text.find("large = 100\n"), 12);  // which a list excludes
  const Runs runs(text);
  std::string list;
  for (int k = 0; k < 40; ++k) list += std::to_string(250 + 5 * k) + "\n";
  write_file(runs.path("list.txt"), list);
  const Answer answer = runs.run("a", {"mixture.diameters=" + runs.path("list.txt"), "stop.steps=10"});
  EXPECT_EQ(runs.result("a")["diameters"]["listed_unit"], 250);
  EXPECT_THAT(content(runs.path("a/log.txt")), HasSubstr("units     1 d_s is 250, the smallest diameter in"));
  write_file(runs.path("list.txt"), "no diameter");  // the run has the list's spheres and needs it no longer
  ASSERT_EQ(runs.resume("a", {"--more", "5"}).code, ExitCode::budget_spent);
  EXPECT_EQ(runs.result("a")["diameters"]["listed_unit"], 250);
  ASSERT_EQ(runs.run("b", {"stop.steps=10"}).code, ExitCode::budget_spent);
  EXPECT_TRUE(runs.result("b")["diameters"]["listed_unit"].is_null());
}

TEST(Run, LeavesItsFolder) {
  const Runs runs;
  ASSERT_EQ(runs.run("a", {"stop.steps=500"}).code, ExitCode::budget_spent);
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(runs.path("a"))) names.insert(entry.path().filename());
  EXPECT_EQ(names,
            (std::set<std::string>{"a.checkpoint", "b.checkpoint", "case.resolved.toml", "cell.vtp",
                                   "contacts.vtp", "history.csv", "log.txt", "manifest.json",
                                   "packing.extxyz", "packing.lammpstrj", "packing.vtp", "result.json"}));
  EXPECT_EQ(runs.files(), 2u);  // the case and the folder
  const Packing packing = saved(runs, "a");
  EXPECT_EQ(packing.step, 500);
  for (const char* file : {"a/packing.vtp", "a/packing.extxyz", "a/packing.lammpstrj"})
    expect_same_packing(packing, read_packing(runs.path(file)));
}

TEST(Run, ASpentBudgetIsNoPhiJ) {
  const Runs runs;
  const Answer answer = runs.run("a", {"stop.steps=300"});
  EXPECT_EQ(answer.code, ExitCode::budget_spent);
  const Json result = runs.result("a");
  EXPECT_EQ(result["verdict"], "budget");
  EXPECT_TRUE(result["phi_J"].is_null());
  EXPECT_EQ(result["steps"], 300);
  EXPECT_THAT(std::string(result["reason"]), HasSubstr("all steps are spent"));
  EXPECT_THAT(answer.out, HasSubstr("no phi_J"));
}

TEST(Run, AWallTimeEndsItToo) {
  const Runs runs;
  const Answer answer =
      runs.run("a", {"compaction.cell=fixed", "stop.steps=1_000_000_000"}, {"--walltime", "0.1s"});
  EXPECT_EQ(answer.code, ExitCode::budget_spent);
  EXPECT_THAT(std::string(runs.result("a")["reason"]), HasSubstr("the wall time is spent"));
}

TEST(Run, AFixedCellNeverJams) {
  const Runs runs;
  ASSERT_EQ(runs.run("a", {"compaction.cell=fixed", "stop.steps=3000"}).code, ExitCode::budget_spent);
  const Json result = runs.result("a");
  EXPECT_TRUE(result["applied_pressure"].is_null());
  EXPECT_TRUE(result["strain_drift_in_2000_t_c"].is_null());
  EXPECT_NEAR(result["phi"], 0.2, 1e-12);
}

TEST(Run, StartsFromAFileOfAnotherProgram) {
  const Runs runs(
      "[start]\nfile = \"start.data\"\n[compaction]\npressure = 1e-3\n[stop]\nsteps = 50\n[output]\npicture "
      "= \"none\"\n");
  fs::copy(test_data("a3.data"), runs.path("start.data"));
  const Answer answer = runs.run("a");
  ASSERT_EQ(answer.code, ExitCode::budget_spent) << answer.err;
  const Packing start = read_packing(test_data("a3.data"));
  const Json result = runs.result("a");
  EXPECT_EQ(result["particles"], start.size());
  EXPECT_EQ(result["steps"], 50);
  EXPECT_EQ(saved(runs, "a").radius, start.radius);
  // The same packing in another file is the same start, but for the last digits of a position.
  ASSERT_EQ(furnas({"import", runs.path("start.data"), "--out", runs.path("start.vtp")}).code,
            ExitCode::done);
  ASSERT_EQ(runs.run("b", {"start.file=" + runs.path("start.vtp")}).code, ExitCode::budget_spent);
  EXPECT_NEAR(runs.result("b")["phi"], double(result["phi"]), 1e-9);
}

/// Threads, and whether somebody asks for checkpoints, change no bit.
TEST(Run, ItsBitsDependOnTheCaseAlone) {
  const Runs runs;
  for (const auto& [name, set] : std::vector<std::pair<std::string, std::vector<std::string>>>{
           {"a", {}},
           {"b", {"compute.threads=2"}},
           {"c", {"compute.skin=0.2"}},
           {"d", {"output.checkpoint_minutes=1e-6"}}}) {
    std::vector<std::string> all = set;
    all.push_back("stop.steps=4000");
    ASSERT_EQ(runs.run(name, all).code, ExitCode::budget_spent);
    EXPECT_EQ(runs.result(name)["state_hash"], runs.result("a")["state_hash"]) << name;
  }
  ASSERT_EQ(runs.run("e", {"stop.steps=4000"}, {"--seed", "2"}).code, ExitCode::budget_spent);
  EXPECT_NE(runs.result("e")["state_hash"], runs.result("a")["state_hash"]);
}

TEST(Run, AStaircaseOfPressuresGetsDenser) {
  const Runs runs;
  ASSERT_EQ(runs.run("a", {"compaction.pressure=[5e-4, 1e-3, 4e-3]"}).code, ExitCode::done);
  const Json states = runs.result("a")["resting_states"];
  ASSERT_EQ(states.size(), 3u);
  const double pressures[] = {5e-4, 1e-3, 4e-3};
  for (std::size_t n = 0; n < 3; ++n) {
    EXPECT_EQ(states[n]["pressure"], pressures[n]);
    if (n == 0) continue;
    EXPECT_GT(states[n]["phi_J"], states[n - 1]["phi_J"]);
    EXPECT_GE(states[n]["step"], int(states[n - 1]["step"]) + 1000) << "each waits for a window of its own";
  }
  EXPECT_EQ(states[2]["phi_J"], runs.result("a")["phi_J"]);
  EXPECT_EQ(runs.result("a")["applied_pressure"], 4e-3);
}

TEST(Run, WritesItsHistoryAndFrames) {
  const Runs runs;
  ASSERT_EQ(runs.run("a", {"stop.steps=1000", "output.snapshot_every=300"}).code, ExitCode::budget_spent);
  const std::string history = content(runs.path("a/history.csv"));
  EXPECT_EQ(std::count(history.begin(), history.end(), '\n'), 11);
  const auto frames = read_frames(runs.path("a/frames.pvd"));
  ASSERT_EQ(frames.size(), 4u) << "the start is the first";
  EXPECT_EQ(frames[0].time, 0);
  for (const SavedFrame& frame : frames) EXPECT_EQ(read_packing(runs.path("a/" + frame.file)).size(), 100u);
}

TEST(Run, TakesFramesAtEqualStepsOfPhi) {
  const Runs runs;
  ASSERT_EQ(runs.run("a", {"stop.steps=4000", "output.snapshot_phi=0.05"}).code, ExitCode::budget_spent);
  const auto frames = read_frames(runs.path("a/frames.pvd"));
  ASSERT_GE(frames.size(), 5u);
  for (std::size_t k = 0; k < frames.size(); ++k) {
    const double phi = read_packing(runs.path("a/" + frames[k].file)).fraction_filled();
    EXPECT_GE(phi, 0.2 + 0.05 * static_cast<double>(k) - 1e-9);
    EXPECT_LT(phi, 0.2 + 0.05 * static_cast<double>(k) + 0.01) << "ten steps later at most";
  }
}

/// A case that cannot be used leaves nothing behind, whatever is wrong with it.
TEST(Run, CreatesNothingForABadCase) {
  const Runs runs;
  const std::size_t files = runs.files();
  struct Bad {
    std::vector<std::string> set, options;
    const char* says;
    ExitCode code = ExitCode::bad_case;
  };
  const Bad table[] = {
      {{"contact.frction=0.3"}, {}, "contact.frction"},
      {{"contact.friction=-1"}, {}, "contact.friction"},
      {{"compaction.pressure=0"}, {}, "compaction.pressure"},
      {{"mixture.size_ratio=0.5"}, {}, "mixture.size_ratio"},
      {{"compaction.time_step_absolute=2"}, {}, "unstable"},
      {{"mixture.small_fraction=0.5", "mixture.size_ratio=100", "mixture.large=2000"},
       {},
       "refused: the run needs about",
       ExitCode::refused},
      {{"start.file=none.data"}, {}, "exclude each other"},
      {{"stop.phi_error=1e-3", "stop.criterion=paper"}, {}, "exclude each other: that criterion"},
      {{"stop.phi_error=1e-3", "compaction.cell=fixed"}, {}, "exclude each other: there phi"},
      {{}, {"--walltime", "soon"}, "--walltime soon"},
      {{}, {"--threads", "0"}, "compute.threads"},
      {{}, {"--seed", "-1"}, "mixture.seed"},
  };
  for (const Bad& bad : table) {
    const Answer answer = runs.run("bad", bad.set, bad.options);
    EXPECT_EQ(answer.code, bad.code) << bad.says;
    EXPECT_THAT(answer.err, HasSubstr(bad.says));
    EXPECT_EQ(std::count(answer.err.begin(), answer.err.end(), '\n'), 1) << answer.err;
    EXPECT_EQ(answer.out, "");
    EXPECT_EQ(runs.files(), files) << bad.says;
  }
}

TEST(Run, CreatesNothingForABadStart) {
  const Runs runs("[output]\npicture = \"none\"\n");
  Packing p = random_packing(1);
  p.fraction[5] = p.fraction[9];
  write_packing(p, "lammps-data", runs.path("twice.data"));
  write_file(runs.path("broken.data"), "a title\n\nnonsense\n");
  const std::size_t files = runs.files();
  for (const auto& [file, says] : std::vector<std::pair<std::string, std::string>>{
           {"twice.data", "twice.data: particle 6 and particle 10 have the same centre"},
           {"broken.data", "broken.data"},
           {"none.data", "none.data"}}) {
    const Answer answer = runs.run("bad", {"start.file=" + runs.path(file)});
    EXPECT_EQ(answer.code, ExitCode::bad_case) << file;
    EXPECT_THAT(answer.err, HasSubstr(says));
    EXPECT_EQ(runs.files(), files) << file;
  }
}

TEST(Run, NeverWritesIntoAnotherRun) {
  const Runs runs;
  ASSERT_EQ(runs.run("a", {"stop.steps=10"}).code, ExitCode::budget_spent);
  const std::string before = content(runs.path("a/result.json"));
  const Answer again = runs.run("a", {"stop.steps=20"});
  EXPECT_EQ(again.code, ExitCode::bad_case);
  EXPECT_THAT(again.err, HasSubstr("already there and not empty"));
  EXPECT_EQ(content(runs.path("a/result.json")), before);
}

/// The version and the hash with which a case of cases/ ends.
std::string end_of_case(const std::string& name, std::vector<std::string> set, ExitCode expected) {
  const Runs runs;
  std::vector<std::string> command{"run", FURNAS_SOURCE_DIR "/cases/" + name + ".toml", "--out",
                                   runs.path("run")};
  set.push_back("output.picture=none");
  for (const std::string& assignment : set) command.insert(command.end(), {"--set", assignment});
  EXPECT_EQ(furnas(command).code, expected);
  const Json result = runs.result("run");
  return result["version"].get<std::string>() + " " + result["state_hash"].get<std::string>();
}

// Runs go on, and samples of a sweep stand together, where the version is the same. Whoever changes a bit of
// a run, by its steps or its events, raises the version in CMakeLists.txt and changes this line with it. The
// hash was made with g++ 12, glibc 2.36 and x86-64, as those of tests/engine/threads_test.cpp.
TEST(Release, ItsVersionStandsForItsBits) {
  if (const std::string differs = test::difference_from_release_machine(); !differs.empty())
    GTEST_SKIP() << differs;
  EXPECT_EQ(end_of_case("smoke", {}, ExitCode::done), "0.3.10 5e739192450e5b01");
}

// The hashes are those of a build of version 0.2.0, of its default case and of its cases/paper.toml with few
// spheres.
TEST(Release, KeysGiveTheBitsOfEarlierOnes) {
  if (const std::string differs = test::difference_from_release_machine(); !differs.empty())
    GTEST_SKIP() << differs;
  EXPECT_EQ(end_of_case("smoke",
                        {"contact.velocity=peculiar", "compaction.time_step=0.02", "compaction.drag=0",
                         "stop.stilling_energy=100", "stop.growth=1e30"},
                        ExitCode::done),
            "0.3.10 2dac9b8be0de00ec");
  EXPECT_EQ(end_of_case("paper",
                        {"compaction.drag=0", "mixture.size_ratio=5", "mixture.large=20",
                         "mixture.start_fraction=0.3", "stop.steps=3000"},
                        ExitCode::budget_spent),
            "0.3.10 11cfa5534b15c78e");
}

}  // namespace
}  // namespace furnas
