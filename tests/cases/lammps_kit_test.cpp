#include "cases/program/lammps_kit.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <nlohmann/json.hpp>

#include "cases/program/packing_source.h"
#include "engine/simulation.h"
#include "io/case_protocol.h"
#include "io/lammps_data.h"
#include "io/lammps_dump.h"
#include "tests/cases/runs.h"

namespace furnas {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// Two sizes, by the law that LAMMPS has, on their way to rest.
constexpr const char* two_sizes = R"([mixture]
size_ratio = 2.0
small_fraction = 0.3
large = 40
start_fraction = 0.3
[contact]
law = "hooke_history"
velocity = "peculiar"
[compaction]
pressure = 1e-3
[stop]
stress_error = 1e-2
force_imbalance = 1e-2
kinetic_energy = 1e-8
strain_drift = 1e-3
window = 200
[compute]
precision = "double"
[output]
picture = "none"
)";

std::string export_kit(const Runs& runs, const std::string& steps) {
  const Answer run = runs.run("run", {"stop.steps=" + steps});
  EXPECT_TRUE(run.code == ExitCode::budget_spent || run.code == ExitCode::done) << run.err;
  const Answer exported = furnas({"export", runs.path("run"), "lammps", "--out", runs.path("kit")});
  EXPECT_EQ(exported.code, ExitCode::done) << exported.err;
  return runs.path("kit");
}

TEST(LammpsKits, HaveTheLawTheBathAndTheColumnsOfTheRun) {
  const Runs runs(two_sizes);
  const std::string kit = export_kit(runs, "500");
  const Packing there = read_lammps_data(kit + "/packing.data");
  const PackingSource here = packing_source(runs.path("run"));
  EXPECT_EQ(there.size(), here.packing.size());
  const std::string deck = content(kit + "/in.furnas");
  const Model model = model_of(*here.of_case, here.packing);
  for (const std::string& line :
       {fmt::format("\ntimestep {}\n", model.time_step), lammps_law(model), lammps_bath(here.packing, model),
        std::string("reset_timestep 500\n"), std::string("neighbor 0.1 multi\n"),
        std::string("title \"Step,Time,Phi,Press,Pxx,")})
    EXPECT_THAT(deck, HasSubstr(line));
  EXPECT_THAT(lammps_bath(here.packing, model), HasSubstr(" drag "));
  const std::string readme = content(kit + "/README");
  EXPECT_EQ(std::count(readme.begin(), readme.end(), '\n'), 3);
  EXPECT_THAT(readme, HasSubstr("mpirun -np 16 lmp -in in.furnas"));
  EXPECT_THAT(readme, HasSubstr("Lost in LAMMPS: the histories of the contacts"));
  EXPECT_THAT(content(kit + "/back.toml"), HasSubstr("file = \"packing.dump\""));
}

TEST(LammpsKits, NeedTheCaseOfTheRun) {
  const Runs runs;
  write_file(runs.path("lone.data"), content(test_data("a3.data")));
  const Answer answer = furnas({"export", runs.path("lone.data"), "lammps", "--out", runs.path("kit")});
  EXPECT_EQ(answer.code, ExitCode::bad_case);
  EXPECT_THAT(answer.err, HasSubstr("contains no case"));
}

TEST(LammpsKits, NameTheBathOfEachKindOfCell) {
  const Packing packing = read_lammps_data(test_data("a3.data"));
  Model model;
  model.barostat.drag = 0.5;
  EXPECT_THAT(lammps_bath(packing, model), HasSubstr("nph/sphere tri 0.0001 0.0001 3 ptemp "));
  EXPECT_THAT(lammps_bath(packing, model), HasSubstr(" pchain 0 flip yes drag 0.75"));
  model.barostat.freedom = CellFreedom::cubic;
  EXPECT_THAT(lammps_bath(packing, model), HasSubstr("nph/sphere iso "));
  model.barostat.freedom = CellFreedom::orthorhombic;
  EXPECT_THAT(lammps_bath(packing, model), HasSubstr("nph/sphere aniso "));
  model.barostat.freedom = CellFreedom::fixed;
  EXPECT_EQ(lammps_bath(packing, model), "fix 1 all nve/sphere");
}

bool has_lammps() { return std::system("command -v lmp mpirun >/dev/null 2>&1") == 0; }

int lammps(const std::string& kit, int ranks, int steps) {
  ::setenv("OMPI_ALLOW_RUN_AS_ROOT", "1", 1);
  ::setenv("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1", 1);
  return std::system(fmt::format("cd '{}' && mpirun --oversubscribe -np {} lmp -in in.furnas -var steps {} "
                                 "-log log.{} >screen.{} 2>&1",
                                 kit, ranks, steps, steps, steps)
                         .c_str());
}

/// Force by force, before the first step: the same law at the same places, without histories.
TEST(NightlyLammpsKit, FirstForcesAreThoseOfLammps) {
  if (!has_lammps()) GTEST_SKIP() << "lmp or mpirun is not installed (Debian: apt-get install lammps)";
  const Runs runs(two_sizes);
  const std::string kit = export_kit(runs, "20000");
  ASSERT_EQ(lammps(kit, 1, 0), 0) << content(kit + "/screen.0");
  const Packing theirs = read_lammps_frame(kit + "/packing.dump");
  const PackingSource source = packing_source(runs.path("run"));
  const Packing ours =
      make_simulation(model_of(*source.of_case, source.packing), for_lammps(source.packing))->packing();
  ASSERT_EQ(theirs.size(), ours.size());
  EXPECT_GT(ours.contacts.size(), ours.size()) << "it is dense";
  double worst = 0;
  for (std::size_t k = 0; k < ours.size(); ++k) {
    const double size = norm(ours.force[k]);
    worst = std::max(worst, size > 0 ? norm(theirs.force[k] - ours.force[k]) / size : norm(theirs.force[k]));
  }
  std::cout << "largest difference of a force " << worst << " of itself\n";
  EXPECT_LT(worst, 1e-6);
}

TEST(NightlyLammpsKit, LammpsGoesOnAndFurnasTakesItBack) {
  if (!has_lammps()) GTEST_SKIP() << "lmp or mpirun is not installed (Debian: apt-get install lammps)";
  const Runs runs(two_sizes);
  const std::string kit = export_kit(runs, "3000");
  const double before = runs.result("run")["phi"];
  ASSERT_EQ(lammps(kit, 2, 2000), 0) << content(kit + "/screen.2000");
  const Answer imported = furnas({"import", kit + "/packing.dump"});
  EXPECT_EQ(imported.code, ExitCode::done) << imported.err;
  const Packing after = read_lammps_frame(kit + "/packing.dump");
  EXPECT_EQ(after.step, 5000);
  EXPECT_GT(after.fraction_filled(), before) << "the same bath goes on";
  EXPECT_THAT(content(kit + "/history.csv"),
              testing::StartsWith("Step,Time,Phi,Press,Pxx,Pyy,Pzz,Pxy,Pxz,Pyz,KinEng,"));

  // The same 2000 steps here, from the same places and velocities.
  const PackingSource source = packing_source(runs.path("run"));
  Model model = model_of(*source.of_case, source.packing);
  model.barostat.legacy = true;
  const auto simulation = make_simulation(model, for_lammps(source.packing));
  simulation->advance(2000);
  const double here = simulation->packing().fraction_filled();
  std::cout << "phi " << before << ", then " << after.fraction_filled() << " by LAMMPS and " << here
            << " by furnas\n";
  EXPECT_NEAR(after.fraction_filled(), here, 0.01 * (here - before));

  const Answer back =
      furnas({"run", kit + "/back.toml", "--out", runs.path("back"), "--set", "stop.steps=400_000"});
  EXPECT_EQ(back.code, ExitCode::done) << back.err;
  EXPECT_EQ(runs.result("back")["verdict"], "jammed");
  const Answer certified = furnas({"certify", runs.path("back")});
  std::cout << certified.out;
  EXPECT_EQ(certified.code, ExitCode::done) << certified.out;
}

}  // namespace
}  // namespace furnas
