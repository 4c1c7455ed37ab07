#include "cases/program/sweep/sweep.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <thread>

#include "cases/program/exit_code.h"
#include "cases/program/sweep/sample_table.h"
#include "tests/cases/process.h"
#include "tests/io/packings.h"

namespace furnas {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;

/// Spheres so few and so soft that a sample takes a tenth of a second.
constexpr const char* soft = R"([mixture]
large = 40
start_fraction = 0.2
[compaction]
pressure = 1e-3
drag = 0.0
time_step = 0.02
[stop]
stress_error = 1e-2
force_imbalance = 1e-2
kinetic_energy = 1e-8
strain_drift = 1e-3
window = 20
steps = 100_000
[output]
picture = "none"
)";

constexpr const char* soft_sweep = R"([[sweep]]
samples = 2
[[sweep]]
"mixture.size_ratio" = 2.0
"mixture.large" = 10
"mixture.small_fraction" = [0.1, 0.3, 0.6]
)";

/// Samples of a second each, that end with their steps and are saved often.
constexpr const char* long_sweep = R"([mixture]
large = 100
start_fraction = 0.25
[stop]
kinetic_energy = 1e-30
steps = 80_000
[output]
checkpoint_minutes = 1e-3
picture = "none"
[sweep]
"contact.friction" = [0.1, 0.3]
samples = 2
)";

class Sweeps : public testing::Test {
 protected:
  void write(const std::string& text) const { write_file(folder_ / "a.toml", text); }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  std::vector<std::string> command(const std::string& out, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> words{"sweep", path("a.toml"), "--out", path(out), "--jobs", "2"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }
  Ending sweep(const std::string& out, const std::vector<std::string>& more = {}) const {
    return ending_of(command(out, more));
  }
  SampleTable table(const std::string& out) const { return read_sample_table(path(out)); }

  /// What says that two sweeps came to the same bits.
  std::vector<std::string> bits(const std::string& out) const {
    std::vector<std::string> all;
    for (const SampleRow& row : table(out).rows)
      all.push_back(row.verdict + " " + std::to_string(row.steps) + " " + row.state_hash);
    return all;
  }
  /// Waits until a sample of the sweep has been saved.
  bool saved(const std::string& out) const {
    for (int n = 0; n < 24'000; ++n) {
      std::error_code moved;  // into its place, while this looks
      for (fs::recursive_directory_iterator at(path(out) + "/samples", moved), end; at != end;
           at.increment(moved))
        if (at->path().filename() == "b.checkpoint") return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return false;
  }

 private:
  TemporaryFolder folder_;
};

TEST_F(Sweeps, FillsItsTablesAndTheFigures) {
  write(std::string(soft) + soft_sweep);
  const Ending first = sweep("out");
  ASSERT_EQ(first.code, 0) << first.out;
  const SampleTable found = table("out");
  ASSERT_EQ(found.rows.size(), 5u);
  for (const SampleRow& row : found.rows) {
    EXPECT_EQ(row.verdict, "jammed") << row.reason;
    EXPECT_GT(row.phi_J, 0.5);
    EXPECT_LT(row.phi_J, 0.85);
    EXPECT_GT(row.Z_backbone, 3);
    EXPECT_EQ(row.state_hash.size(), 16u);
  }
  const std::string points = content(path("out/points.csv"));
  EXPECT_EQ(std::count(points.begin(), points.end(), '\n'), 1 + 4);
  EXPECT_THAT(content(path("out/maxima.csv")), HasSubstr("f_max"));

  const Ending again = sweep("out");
  ASSERT_EQ(again.code, 0);
  EXPECT_THAT(again.out, HasSubstr("5 of 5 samples are finished and not run again"));
  EXPECT_EQ(bits("out").size(), 5u);

  const Ending drawn = ending_of({"figures", path("out"), "--out", path("figures")});
  ASSERT_EQ(drawn.code, 0) << drawn.out;
  for (const char* name :
       {"figure_1b_history", "figure_2_friction_0.3", "figure_3a_phi_max", "figure_3b_f_max",
        "figure_4_rattlers_size_ratio_2", "phi_large_friction_0.3", "phi_small_friction_0.3"})
    for (const char* extension : {".csv", ".png", ".svg"})
      EXPECT_GT(fs::file_size(path("figures/") + name + extension), 60u) << name << extension;
  EXPECT_THAT(content(path("figures/report.md")), HasSubstr("| not reachable here |"));

  const Ending model =
      ending_of({"model", "--sweep", path("out"), "--friction", "0.3", "--out", path("m.csv")});
  ASSERT_EQ(model.code, 0) << model.out;
  EXPECT_THAT(model.out, AllOf(HasSubstr("f_max"), HasSubstr("95 % intervals")));
  EXPECT_THAT(content(path("m.csv")), HasSubstr("f_s,phi,low,high"));

  const Ending plot = ending_of({"plot", path("out"), "--y", "energy.kinetic", "--out", path("plots/k")});
  ASSERT_EQ(plot.code, 0) << plot.out;
  for (const char* extension : {".csv", ".png", ".svg"})
    EXPECT_GT(fs::file_size(path("plots/k") + extension), 60u) << extension;
  EXPECT_THAT(content(path("plots/k.csv")), HasSubstr("series,mixture.small_fraction,energy.kinetic,low"));
}

TEST_F(Sweeps, OfEqualSpheresFollowFromTheCommandThatTheModelAsksFor) {
  write(std::string(soft) + "[sweep]\n\"mixture.size_ratio\" = 2.0\n\"mixture.large\" = 10\n" +
        "\"mixture.small_fraction\" = [0.3, 0.6]\n");
  ASSERT_EQ(sweep("out").code, 0);
  const Ending asked = ending_of({"model", "--sweep", path("out"), "--friction", "0.3"});
  EXPECT_EQ(asked.code, 2);
  const std::string command = "furnas sweep " + path("out/base_case.toml") + " --samples 8";
  EXPECT_THAT(asked.out, HasSubstr(command));
  EXPECT_THAT(ending_of({"plot", path("out"), "--out", path("p.csv")}).out, HasSubstr(command));
  // The same with fewer and smaller samples.
  ASSERT_EQ(ending_of({"sweep", path("out/base_case.toml"), "--samples", "2", "--set",
                       "mixture.size_ratio=1.0", "--set", "mixture.small_fraction=0.0", "--set",
                       "mixture.large=40", "--set", "contact.friction=0.3", "--out", path("mono")})
                .code,
            0);
  EXPECT_EQ(table("mono").rows.size(), 2u);
  EXPECT_EQ(ending_of({"model", "--sweep", path("out"), "--sweep", path("mono"), "--friction", "0.3"}).code,
            0);
  ASSERT_EQ(ending_of({"plot", path("out"), path("mono"), "--out", path("p.csv")}).code, 0);
  EXPECT_THAT(content(path("p.csv")), HasSubstr("model; φ_{mono}"));
}

TEST_F(Sweeps, OfAnotherPressureAreNotMixed) {
  write(std::string(soft) + "[sweep]\nsamples = 2\n");
  ASSERT_EQ(sweep("out").code, 0);
  ASSERT_EQ(sweep("other", {"--set", "compaction.pressure=2e-3"}).code, 0);
  const Ending refused = ending_of({"figures", path("out"), path("other"), "--out", path("figures")});
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.out, HasSubstr("differ in compaction.pressure (0.001, 0.002)"));
  EXPECT_FALSE(fs::exists(path("figures")));
  const Ending plot = ending_of({"plot", path("out"), path("other"), "--out", path("p.csv")});
  ASSERT_EQ(plot.code, 0) << plot.out;
  EXPECT_THAT(content(path("p.csv")), HasSubstr("series,compaction.pressure,phi_J,low,high"));
}

TEST_F(Sweeps, RefinesTheMaxima) {
  write(
      std::string(soft) +
      "[sweep]\n\"mixture.size_ratio\" = 2.0\n\"mixture.large\" = 5\n\"mixture.small_fraction\" = [0.1, 0.4, "
      "0.7]\n");
  ASSERT_EQ(sweep("out", {"--refine"}).code, 0);
  const std::size_t refined = table("out").rows.size();
  EXPECT_GT(refined, 3u);
  ASSERT_EQ(sweep("out").code, 0);
  EXPECT_EQ(table("out").rows.size(), refined) << "what was added stays";
}

TEST_F(Sweeps, ABadPointStopsNoOther) {
  // Without friction and damping nothing takes energy out: the run refuses it.
  write(std::string(soft) +
        "[sweep]\n\"contact.friction\" = [0.0, 0.3]\n\"contact.normal_damping\" = [0.0, 0.5]\n"
        "\"stop.steps\" = [2000, 100000]\n");
  const Ending checked = ending_of({"check", path("a.toml")});
  EXPECT_EQ(checked.code, 0);
  EXPECT_THAT(checked.out, AllOf(HasSubstr("8 at 8 points"), HasSubstr("nothing takes energy out")));
  const Ending end = sweep("out");
  ASSERT_EQ(end.code, static_cast<int>(ExitCode::samples_failed)) << end.out;
  int jammed = 0, budget = 0, failed = 0;
  for (const SampleRow& row : table("out").rows) {
    jammed += row.verdict == "jammed";
    budget += row.verdict == "budget";
    failed += row.verdict == "failed";
    if (row.verdict == "failed") {
      EXPECT_THAT(row.reason, HasSubstr("nothing takes energy out"));
    }
  }
  EXPECT_EQ(failed, 2);
  EXPECT_EQ(budget, 3);
  EXPECT_EQ(jammed, 3);
}

/// Starts lie beside the case file, wherever the sweep is called, and are looked at before anything runs.
TEST_F(Sweeps, TakesStartsFromBesideTheCaseFile) {
  const auto start = [](int spheres) {
    std::string rows;
    for (int k = 0; k < spheres; ++k) rows += std::to_string(2 * k) + " 1 1 0.5\n";
    return std::to_string(spheres) + "\nLattice=\"9 0 0 0 9 0 0 0 9\" Properties=pos:R:3:radius:R:1\n" + rows;
  };
  fs::create_directories(path("x"));
  fs::create_directories(path("y"));
  write_file(path("x/unit.xyz"), start(3));
  write_file(path("y/unit.xyz"), start(4));
  const std::string rest = "[stop]\nsteps = 50\n[output]\npicture = \"none\"\n[sweep]\n";
  write(rest + "\"start.file\" = [\"x/unit.xyz\", \"y/unit.xyz\"]\n");
  const Ending checked = ending_of({"check", path("a.toml")});
  EXPECT_EQ(checked.code, 0) << checked.out;
  EXPECT_THAT(checked.out, HasSubstr("particles at most 4 in a sample"));
  const Ending end = sweep("out");
  EXPECT_EQ(end.code, static_cast<int>(ExitCode::budget_spent)) << end.out;
  ASSERT_EQ(table("out").rows.size(), 2u);
  EXPECT_EQ(table("out").rows[0].large, 3);
  EXPECT_EQ(table("out").rows[1].large, 4);
  EXPECT_EQ(table("out").keys, (std::vector<std::string>{"contact.friction", "start.file"}));
  write(rest + "\"start.file\" = [\"x/none.xyz\"]\n");
  for (const Ending& wrong : {ending_of({"check", path("a.toml")}), sweep("none")}) {
    EXPECT_EQ(wrong.code, 2);
    EXPECT_THAT(wrong.out, AllOf(HasSubstr("a.toml:6: start.file"), HasSubstr("is not a file")));
  }
}

/// Too light for the time step: every sample is refused.
TEST_F(Sweeps, SaysThatAllSamplesHaveFailed) {
  write_file(path("light.xyz"),
             "2\nLattice=\"9 0 0 0 9 0 0 0 9\" Properties=pos:R:3:radius:R:1:mass:R:1\n"
             "1 1 1 0.5 0.001\n5 5 5 0.5 0.001\n");
  write("[stop]\nsteps = 50\n[output]\npicture = \"none\"\n[sweep]\n\"start.file\" = [\"light.xyz\"]\n");
  EXPECT_THAT(ending_of({"check", path("a.toml")}).out, HasSubstr("too long for the two lightest spheres"));
  EXPECT_EQ(sweep("out").code, static_cast<int>(ExitCode::samples_failed));
  EXPECT_EQ(table("out").rows.at(0).verdict, "failed");
}

TEST_F(Sweeps, RefusesAnotherCaseInItsFolder) {
  write(std::string(soft) + "[sweep]\nsamples = 1\n");
  ASSERT_EQ(sweep("out").code, 0);
  const Ending other = sweep("out", {"--set", "contact.normal_damping=0.4"});
  EXPECT_EQ(other.code, 2);
  EXPECT_THAT(other.out, HasSubstr("holds the run of another case"));
}

TEST_F(Sweeps, RefusesTheFolderOfARun) {
  write(std::string(soft));
  ASSERT_EQ(ending_of({"run", path("a.toml"), "--out", path("run"), "--set", "stop.steps=0"}).code, 5);
  write(std::string(soft) + soft_sweep);
  const Ending refused = sweep("run");
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.out, HasSubstr("is the folder of a run"));
}

TEST_F(Sweeps, GivesASpentBudgetMore) {
  write(std::string(soft) + "[sweep]\nsamples = 1\n");
  ASSERT_EQ(sweep("out", {"--set", "stop.steps=2000"}).code, static_cast<int>(ExitCode::budget_spent));
  EXPECT_EQ(table("out").rows[0].verdict, "budget");
  ASSERT_EQ(sweep("out").code, 0);
  EXPECT_EQ(table("out").rows[0].verdict, "jammed");
  ASSERT_EQ(sweep("whole").code, 0);
  EXPECT_EQ(bits("out"), bits("whole"));
}

/// A sample that has settled is finished, until the sweep asks for a smaller bound or for rest.
TEST_F(Sweeps, CarriesSettledSamplesOnToASmallerBound) {
  write(R"([mixture]
large = 60
start_fraction = 0.3
[compaction]
pressure = 1e-3
[stop]
strain_drift = 1e-30
steps = 100_000
[output]
picture = "none"
[sweep]
samples = 1
)");
  ASSERT_EQ(sweep("out", {"--set", "stop.phi_error=1e-2"}).code, 0);
  const SampleRow settled = table("out").rows.at(0);
  EXPECT_EQ(settled.verdict, "settled");
  EXPECT_GT(settled.phi_bound, 0);
  EXPECT_LT(settled.phi_bound, 1e-2);
  ASSERT_EQ(sweep("out", {"--set", "stop.phi_error=1e-2"}).code, 0);
  EXPECT_EQ(table("out").rows.at(0).steps, settled.steps);
  ASSERT_EQ(sweep("out").code, static_cast<int>(ExitCode::budget_spent));
  EXPECT_EQ(table("out").rows.at(0).verdict, "budget");
  EXPECT_EQ(table("out").rows.at(0).steps, 100'000);
  ASSERT_EQ(sweep("whole").code, static_cast<int>(ExitCode::budget_spent));
  EXPECT_EQ(bits("out"), bits("whole"));
}

TEST_F(Sweeps, StoppedOrKilledGoesOnToTheSameBits) {
  write(long_sweep);
  ASSERT_EQ(sweep("whole").code, static_cast<int>(ExitCode::budget_spent));
  for (const int signal : {SIGTERM, SIGINT, SIGKILL}) {
    const std::string out = "stopped" + std::to_string(signal);
    Process process(command(out));
    ASSERT_TRUE(saved(out));
    process.signal(signal);
    const Ending stopped = process.wait();
    if (signal == SIGKILL) {
      EXPECT_EQ(stopped.signal, SIGKILL);  // its samples may still be saving
    } else {
      EXPECT_EQ(stopped.code, 130) << stopped.out;
      EXPECT_THAT(stopped.out, HasSubstr("all samples are saved"));
    }
    const Ending end = sweep(out);
    ASSERT_EQ(end.code, static_cast<int>(ExitCode::budget_spent)) << end.out;
    EXPECT_EQ(bits(out), bits("whole"));
  }
}

TEST(NightlySweep, TheSmokeStudyMakesAllFigures) {
  const TemporaryFolder folder;
  const std::string out = (folder / "smoke").string();
  Process run({"sweep", std::string(FURNAS_SOURCE_DIR) + "/cases/study/smoke.toml", "--out", out});
  const int code = run.wait().code;
  ASSERT_TRUE(code == 0 || code == static_cast<int>(ExitCode::budget_spent)) << code;
  const SampleTable table = read_sample_table(out);
  EXPECT_EQ(table.rows.size(), 46u);
  EXPECT_GE(std::count_if(table.rows.begin(), table.rows.end(), [](const auto& row) { return row.jammed(); }),
            40);
  Process draw({"figures", out});
  ASSERT_EQ(draw.wait().code, 0);
  for (const char* name :
       {"figure_1b_history", "figure_2_friction_0", "figure_2_friction_0.3", "figure_3a_phi_max",
        "figure_3b_f_max", "figure_4_rattlers_size_ratio_2", "figure_4_rattlers_size_ratio_3"})
    EXPECT_TRUE(fs::exists(out + "/figures/" + name + ".png")) << name;
}

}  // namespace
}  // namespace furnas
