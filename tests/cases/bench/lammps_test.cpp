#include "cases/program/bench/lammps.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "cases/program/bench/packings.h"
#include "cases/program/bench/peers.h"
#include "engine/base/require.h"
#include "engine/simulation.h"
#include "io/lammps_data.h"
#include "io/lammps_dump.h"
#include "tests/cases/runs.h"

namespace furnas {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// While it lives, programs are looked for in `folder` first, or in it alone.
class Path {
 public:
  Path(const fs::path& folder, bool alone) : before_(std::getenv("PATH")) {
    ::setenv("PATH", (folder.string() + (alone ? "" : ":" + before_)).c_str(), 1);
  }
  ~Path() { ::setenv("PATH", before_.c_str(), 1); }
  Path(const Path&) = delete;
  Path& operator=(const Path&) = delete;

 private:
  std::string before_;
};

void write_program(const fs::path& file, const std::string& text) {
  write_file(file, "#!/bin/sh\n" + text);
  fs::permissions(file, fs::perms::owner_all);
}

TEST(LammpsDeck, HasTheBathAndTheLawOfTheModel) {
  const Packing packing = read_lammps_data(test_data("a3.data"));
  Model model = model_for({"hooke_history", 0.3, "double"}, packing);
  model.barostat.inertia = 9.0 * static_cast<double>(packing.size() + 1);
  const std::string deck = lammps_deck(packing, model);
  EXPECT_THAT(deck, HasSubstr("fix 1 all nph/sphere tri 0.0001 0.0001 3 ptemp 1 pchain 0"));
  EXPECT_THAT(deck, HasSubstr("gran/hooke/history 1.0 1 0.5 0.5 0.3 1\n"));
  model.barostat.freedom = CellFreedom::fixed;
  EXPECT_THAT(lammps_deck(packing, model), HasSubstr("fix 1 all nve/sphere\n"));
  const Model smooth = model_for({"hooke_history", 0, "double"}, packing);
  EXPECT_THAT(lammps_deck(packing, smooth), HasSubstr("gran/hooke/history 1.0 0.0 0.5 0.0 0.0 0\n"));
}

TEST(LammpsLog, TellsTimeRebuildsAndComplaints) {
  const TemporaryFolder folder;
  write_file(folder / "log",
             "Loop time of 1.5 on 2 procs for 100 steps with 320 atoms\nNeighbor list builds = 7\n");
  const LammpsTiming timing = timing_in(folder / "log");
  EXPECT_EQ(timing.seconds, 1.5);
  EXPECT_EQ(timing.rebuilds, 7);
  write_file(folder / "bad", "ERROR: Lost atoms\n");
  EXPECT_THROW(timing_in(folder / "bad"), std::runtime_error);
  write_file(folder / "cut", "LAMMPS (29 Sep 2021)\n");
  EXPECT_THROW(timing_in(folder / "cut"), std::runtime_error);
}

TEST(BenchPeers, SaysWhenThereIsNoLammps) {
  const Runs runs;
  const Path nothing(runs.path(""), true);
  const Answer answer = furnas({"bench", "peers", test_data("a3.data"), "--ranks", "1"});
  EXPECT_EQ(answer.code, ExitCode::bad_case);
  EXPECT_THAT(answer.err, HasSubstr("lmp is not on the PATH"));
}

/// A program in the place of LAMMPS that knows the forces and always takes a second: all around it is real.
TEST(BenchPeers, PlaysInTurnAndComparesForces) {
  const Runs runs;
  const Packing packing = read_lammps_data(test_data("a3.data"));
  Packing forces = make_simulation(model_for({"hooke_history", 0.3, "double"}, packing), packing)->packing();
  write_lammps_dump(forces, runs.path("known.dump"));
  write_program(
      runs.path("lmp"),
      "cp '" + runs.path("known.dump") +
          "' forces.dump\n"
          "case \"$*\" in *'style multi'*'skin 0.1 '*) t=0.5 ;; *) t=1 ;; esac\n"
          "echo \"Loop time of $t on 1 procs for 10 steps\nNeighbor list builds = 3\" >log.lammps\n");
  const Path path(runs.path(""), false);
  const Answer answer =
      furnas({"bench", "peers", test_data("a3.data"), "--ranks", "1", "--precision", "double", "--steps",
              "10", "--pairs", "2", "--skins", "0.05,0.1", "--out", runs.path("work")});
  ASSERT_EQ(answer.code, ExitCode::done) << answer.err;
  EXPECT_THAT(answer.out, HasSubstr("best: multi, skin 0.1\n"));
  EXPECT_THAT(answer.out, HasSubstr("LAMMPS  0.0064 (0.0064 - 0.0064) Mps"));
  EXPECT_THAT(answer.out, HasSubstr("differ by 0.0e+00 (median)"));
  EXPECT_TRUE(fs::exists(runs.path("work/packing.data")));
}

/// The real one, where it is installed: forces agree to rounding.
TEST(BenchPeers, AgreesWithLammps) {
  const TemporaryFolder folder;
  const Packing packing = read_lammps_data(test_data("a3.data"));
  const Model model = model_for({"hooke_history", 0.3, "double"}, packing);
  try {
    const Lammps lammps(folder / "", packing, model, 1);
    const ForceDifference d =
        difference_of_forces(make_simulation(model, packing)->packing(), lammps.forces().force);
    EXPECT_LT(d.largest, 1e-10);
    EXPECT_GT(lammps.run({"multi", 0.1}, 20).seconds, 0);
  } catch (const InputError& missing) {
    GTEST_SKIP() << missing.what();
  }
}

}  // namespace
}  // namespace furnas
