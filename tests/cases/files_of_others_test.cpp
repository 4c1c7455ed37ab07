#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "io/formats.h"
#include "tests/cases/runs.h"

namespace furnas {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// Two spheres of density 4 that run towards each other.
constexpr const char* heavy_pair = R"(two heavy spheres, timestep = 70

2 atoms
1 atom types

0 8 xlo xhi
0 8 ylo yhi
0 8 zlo zhi

Atoms # sphere

3 1 1 4.0 3.0 4 4 1 0 -2
7 1 1 4.0 4.1 4 4 0 0 0

Velocities

3 0.01 0 0 0 0 0
7 -0.01 0 0 0 0 0
)";

constexpr const char* fixed_case = R"([start]
file = "dens.data"
[compaction]
cell = "fixed"
[stop]
steps = 2000
[output]
picture = "none"
)";

std::string with_replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
  return text;
}

std::string frame_of(int edge, const std::string& more = "") {
  return fmt::format(
      "2\nLattice=\"{0} 0 0 0 {0} 0 0 0 {0}\" Properties=species:S:1:pos:R:3:radius:R:1\n"
      "A 1 1 1 0.5\nB 3 3 3 0.25\n{1}",
      edge, more);
}

TEST(FilesOfOthers, ATrajectoryGivesItsLastFrameOrTheOneAskedFor) {
  const Runs runs;
  write_file(runs.path("t.xyz"), frame_of(4) + frame_of(8));
  const auto edge = [&](const std::vector<std::string>& how) {
    std::vector<std::string> arguments{"import", runs.path("t.xyz"), "--out", runs.path("t.data")};
    arguments.insert(arguments.end(), how.begin(), how.end());
    const Answer answer = furnas(arguments);
    EXPECT_EQ(answer.code, ExitCode::done) << answer.err;
    return read_packing(runs.path("t.data")).cell.edges.xx;
  };
  EXPECT_EQ(edge({}), 8);
  EXPECT_EQ(edge({"--frame", "1"}), 4);
  EXPECT_THAT(furnas({"import", runs.path("t.xyz"), "--frame", "3"}).err, HasSubstr("allowed: 1 to 2"));
  EXPECT_THAT(furnas({"import", runs.path("t.data"), "--frame", "2"}).err, HasSubstr("contains one packing"));
  write_file(runs.path("t.xyz"), frame_of(4, "C 1 3 1 0.25\n"));
  const Answer surplus = furnas({"import", runs.path("t.xyz")});
  EXPECT_EQ(surplus.code, ExitCode::bad_case);
  EXPECT_THAT(surplus.err, HasSubstr("t.xyz:5: more rows than the 2"));
}

/// Density, image flags, ids and step of a data file come back through every format.
TEST(FilesOfOthers, NothingIsLostOnTheWayThroughAnotherFormat) {
  const Runs runs;
  write_file(runs.path("dens.data"), heavy_pair);
  for (const char* other : {"lammpstrj", "extxyz", "vtp"}) {
    const std::string between = runs.path(std::string("a.") + other);
    ASSERT_EQ(furnas({"import", runs.path("dens.data"), "--out", between}).code, ExitCode::done);
    ASSERT_EQ(furnas({"import", between, "--out", runs.path("back.data")}).code, ExitCode::done);
    const std::string back = content(runs.path("back.data"));
    EXPECT_THAT(back, HasSubstr("\n3 1 1 4 3 4 4 1 0 -2\n")) << other;
    EXPECT_THAT(back, HasSubstr("\n7 1 1 4 4.1 4 4 0 0 0\n")) << other;
    EXPECT_THAT(back, HasSubstr("timestep = 70\n")) << other;
    EXPECT_THAT(back, HasSubstr("\n7 -0.01 0 0 0 0 0\n")) << other;
  }
}

TEST(FilesOfOthers, WhatAFormatCannotHoldIsSaid) {
  const Runs runs;
  ASSERT_EQ(runs.run("a", {"stop.steps=3000"}).code, ExitCode::budget_spent);
  const Answer data = furnas({"export", runs.path("a"), "lammps-data", "--out", runs.path("a.data")});
  EXPECT_THAT(data.err, AllOf(HasSubstr("lammps-data cannot store the time, forces"),
                              HasSubstr("contacts with their histories")));
  const Answer back = furnas({"import", runs.path("a.data"), "--out", runs.path("b.lammpstrj")});
  EXPECT_EQ(back.err, "") << "nothing more is lost";
}

/// 30 spheres of each of two species of one size, and a file whose type 1 is small.
TEST(FilesOfOthers, TwoTypesAreTheTwoSpecies) {
  const Runs runs;
  ASSERT_EQ(runs.run("a", {"mixture.small_fraction=0.5", "mixture.large=60", "stop.steps=100"}).code,
            ExitCode::budget_spent);
  ASSERT_EQ(furnas({"export", runs.path("a"), "lammps-data", "--out", runs.path("a/a.data")}).code,
            ExitCode::done);
  for (const char* file : {"a/packing.extxyz", "a/packing.lammpstrj", "a/packing.vtp", "a/a.data"})
    EXPECT_THAT(furnas({"import", runs.path(file)}).out, HasSubstr("120 particles, 60 large")) << file;
  const std::string small_first =
      with_replaced(with_replaced(heavy_pair, "1 atom types", "2 atom types"), "7 1 1 4.0", "7 2 3 4.0");
  write_file(runs.path("s.data"), small_first);
  for (const char* other : {"lammpstrj", "extxyz", "vtp", "data"}) {
    ASSERT_EQ(furnas({"import", runs.path("s.data"), "--out", runs.path(std::string("b.") + other)}).code,
              ExitCode::done);
    ASSERT_EQ(furnas({"import", runs.path(std::string("b.") + other), "--out", runs.path("c.data")}).code,
              ExitCode::done);
    EXPECT_THAT(content(runs.path("c.data")), AllOf(HasSubstr("\n3 1 1 4 "), HasSubstr("\n7 2 3 4 ")))
        << other;
  }
}

/// 64 spheres of 64 sizes: none of them is the large one.
TEST(FilesOfOthers, ManySizesAreSaidToBeMany) {
  const Runs runs;
  std::string rows;
  for (int k = 0; k < 64; ++k)
    rows += fmt::format("A {} {} {} {}\n", k % 4, k / 4 % 4, k / 16, 0.5 + 1e-3 * k);
  write_file(runs.path("p.xyz"),
             "64\nLattice=\"4 0 0 0 4 0 0 0 4\" Properties=species:S:1:pos:R:3:radius:R:1\n" + rows);
  EXPECT_THAT(furnas({"import", runs.path("p.xyz")}).out,
              HasSubstr("64 sizes from 1 to 1.126 (polydisperse)"));
  const Answer answer = furnas({"analyze", runs.path("p.xyz"), "--out", runs.path("out")});
  ASSERT_EQ(answer.code, ExitCode::done) << answer.err;
  EXPECT_THAT(answer.out,
              AllOf(HasSubstr("64 spheres"), HasSubstr("polydisperse"), Not(HasSubstr(" large,"))));
  const auto json = nlohmann::json::parse(content(runs.path("out/analysis.json")));
  for (const char* none : {"small_fraction", "phi_L", "phi_S", "large", "small"})
    EXPECT_TRUE(json[none].is_null()) << none;
  EXPECT_EQ(json["sizes"], 64);
  EXPECT_GT(json["phi"], 0.5);
  EXPECT_EQ(json["pair_correlation"][0]["kind"], "all");
  EXPECT_EQ(json["network"]["coordination"]["contacts"], 3 * 64);
  write_file(runs.path("p.toml"),
             "[start]\nfile = \"p.xyz\"\n[stop]\nsteps = 100\n[output]\npicture = \"none\"\n");
  EXPECT_THAT(furnas({"check", runs.path("p.toml")}).out,
              AllOf(HasSubstr("particles 64: 64 sizes from 1 to 1.126"), HasSubstr("smallest-largest")));
  ASSERT_EQ(furnas({"run", runs.path("p.toml"), "--out", runs.path("p")}).code, ExitCode::budget_spent);
  EXPECT_TRUE(runs.result("p")["large"].is_null());
  EXPECT_EQ(runs.result("p")["polydisperse"], true);
  EXPECT_THAT(content(runs.path("p/packing.extxyz")), Not(HasSubstr("large")));
}

TEST(FilesOfOthers, ARunKeepsIdsAndTypes) {
  const Runs runs;
  write_file(runs.path("dens.data"), with_replaced(heavy_pair, "1 atom types", "1 atom types # Cu"));
  write_file(runs.path("dens.toml"), fixed_case);
  ASSERT_EQ(furnas({"run", runs.path("dens.toml"), "--out", runs.path("a")}).code, ExitCode::budget_spent);
  EXPECT_THAT(content(runs.path("a/packing.extxyz")),
              AllOf(HasSubstr("\nCu Cu 1 3 "), HasSubstr("\nCu Cu 1 7 ")));
  ASSERT_EQ(furnas({"export", runs.path("a"), "lammps-data", "--out", runs.path("b.data")}).code,
            ExitCode::done);
  EXPECT_THAT(content(runs.path("b.data")), AllOf(HasSubstr("# Cu\n"), HasSubstr("\n7 1 1 4 ")));
}

/// e = exp(-gamma t_c/2) of two spheres of density 4, and of what the run finds.
TEST(FilesOfOthers, CheckTakesTheMassesOfTheStart) {
  const Runs runs;
  write_file(runs.path("dens.data"), heavy_pair);
  write_file(runs.path("dens.toml"), fixed_case);
  const double reduced = 4 * std::numbers::pi / 6 / 2;
  const double restitution = std::exp(-0.25 * std::numbers::pi / std::sqrt(1 / reduced - 0.0625));
  const Answer answer = furnas({"check", runs.path("dens.toml")});
  EXPECT_EQ(answer.code, ExitCode::done) << answer.err;
  EXPECT_THAT(answer.out, HasSubstr(fmt::format("large-large  restitution {:.4f}", restitution)));
  EXPECT_THAT(answer.out, HasSubstr("density   4\n"));
  ASSERT_EQ(furnas({"run", runs.path("dens.toml"), "--out", runs.path("a"), "--set", "contact.friction=0",
                    "--set", "compaction.time_step=0.0025", "--set", "stop.steps=20_000"})
                .code,
            ExitCode::budget_spent);
  const Packing after = read_packing(runs.path("a/packing.vtp"));
  EXPECT_NEAR((after.velocity[1].x - after.velocity[0].x) / 0.02, restitution, 0.001)
      << "the pair parts within a step";
}

TEST(FilesOfOthers, CheckRefusesAnUnstableStart) {
  const Runs runs;
  write_file(runs.path("dens.toml"), fixed_case);
  write_file(runs.path("dens.data"),
             with_replaced(with_replaced(heavy_pair, " 4.0 3.0", " 0.002 3.0"), " 4.0 4.1", " 0.002 4.1"));
  for (const char* command : {"check", "run"}) {
    const Answer answer = furnas({command, runs.path("dens.toml")});
    EXPECT_EQ(answer.code, ExitCode::refused);
    EXPECT_THAT(answer.err, AllOf(HasSubstr("too long for the two lightest spheres"),
                                  HasSubstr("allowed: compaction.time_step_absolute below")));
  }
  EXPECT_EQ(runs.files(), 3u) << "nothing was made";
}

/// A file in metres and kilograms: what is said of it is the command that mends it.
TEST(FilesOfOthers, AFileInOtherUnitsIsRescaled) {
  const Runs runs;
  write_file(runs.path("dens.data"),
             "SI\n\n2 atoms\n1 atom types\n\n0 0.008 xlo xhi\n0 0.008 ylo yhi\n0 0.008 zlo zhi\n\nAtoms\n\n"
             "1 1 0.001 2500 0.003 0.004 0.004\n2 1 0.001 2500 0.0041 0.004 0.004\n\nVelocities\n\n"
             "1 0.01 0 0 0 0 0\n2 -0.01 0 0 0 0 0\n");
  write_file(runs.path("dens.toml"), fixed_case);
  const auto tells = AllOf(HasSubstr("diameter 0.001"), HasSubstr("--scale 1000 --density 2500 --out"));
  EXPECT_THAT(furnas({"check", runs.path("dens.toml")}).out, tells);
  EXPECT_THAT(furnas({"run", runs.path("dens.toml"), "--out", runs.path("a")}).err, tells);
  EXPECT_EQ(furnas({"check", runs.path("dens.toml")}).code, ExitCode::refused);
  EXPECT_FALSE(std::filesystem::exists(runs.path("a"))) << "nothing was run";
  ASSERT_EQ(furnas({"import", runs.path("dens.data"), "--scale", "1000", "--density", "2500", "--out",
                    runs.path("start.data")})
                .code,
            ExitCode::done);
  const Packing p = read_packing(runs.path("start.data"));
  EXPECT_NEAR(p.radius[0], 0.5, 1e-15);
  EXPECT_NEAR(p.mass[0], std::numbers::pi / 6, 1e-14);
  EXPECT_NEAR(p.cell.edges.xx, 8, 1e-14);
  EXPECT_NEAR(p.velocity[0].x, 10, 1e-13) << "the unit of time stays";
  EXPECT_LT(norm(p.position(1) - Vec3<double>{4.1, 4, 4}), 1e-14);
}

/// fcc in its cell of 4, pressed to p = 1e-4. Springs of stiffness 1 along 6 bonds a sphere.
std::string crystal() {
  const double overlap = 1e-4 / (2 * std::sqrt(2.0)), edge = std::sqrt(2.0) * (1 - overlap), half = edge / 2;
  return fmt::format(
      "4\nLattice=\"{0} 0 0 0 {0} 0 0 0 {0}\" Properties=pos:R:3:radius:R:1\n"
      "0 0 0 0.5\n{1} {1} 0 0.5\n{1} 0 {1} 0.5\n0 {1} {1} 0.5\n",
      edge, half);
}

TEST(FilesOfOthers, APackingInAFileIsCertified) {
  const Runs runs;
  write_file(runs.path("fcc.xyz"), crystal());
  EXPECT_THAT(furnas({"certify", runs.path("fcc.xyz")}).err, HasSubstr("or a packing with --pressure"));
  const Answer answer = furnas({"certify", runs.path("fcc.xyz"), "--pressure", "1e-4"});
  EXPECT_EQ(answer.code, ExitCode::done) << answer.err << answer.out;
  EXPECT_THAT(answer.out, HasSubstr("0.9429"));
  EXPECT_EQ(furnas({"certify", runs.path("fcc.xyz"), "--pressure", "2e-4"}).code, ExitCode::not_certified);
  EXPECT_EQ(furnas({"certify", runs.path("fcc.xyz"), "--pressure", "1e-4", "--friction", "0.3"}).code,
            ExitCode::done);
}

/// Twelve neighbours, six at sqrt 2 and 24 at sqrt 3, of which many are images of the sphere itself.
TEST(FilesOfOthers, PairCorrelationCountsOwnImages) {
  const Runs runs;
  write_file(runs.path("fcc.xyz"), crystal());
  ASSERT_EQ(
      furnas({"analyze", runs.path("fcc.xyz"), "--reach", "1.8", "--out", runs.path("out"), "--no-pictures"})
          .code,
      ExitCode::done);
  std::istringstream table(content(runs.path("out/pair_correlation.csv")));
  std::vector<std::string> steps;
  for (std::string line; std::getline(table, line);) {
    const std::string neighbours = line.substr(line.rfind(',') + 1);
    if (steps.empty() || steps.back() != neighbours) steps.push_back(neighbours);
  }
  EXPECT_THAT(steps, testing::ElementsAre("neighbours", "0", "12", "18", "42"));
}

/// Crystals in their smallest cells, as ASE writes them, with CRLF and BOM: exact phi and Z.
TEST(FilesOfOthers, CrystalsHaveTheirPackingFractionAndCoordination) {
  const Runs runs;
  struct Crystal {
    const char* name;
    const char* lattice;  ///< of cubes of edge 1
    double edge;          ///< at contact
    double phi;
    int coordination;
  };
  const double pi = std::numbers::pi;
  const Crystal table[] = {
      {"sc", "1 0 0 0 1 0 0 0 1", 1, pi / 6, 6},
      {"bcc", "-0.5 0.5 0.5 0.5 -0.5 0.5 0.5 0.5 -0.5", 2 / std::sqrt(3.0), pi * std::sqrt(3.0) / 8, 8},
      {"fcc", "0 0.5 0.5 0.5 0 0.5 0.5 0.5 0", std::sqrt(2.0), pi / std::sqrt(18.0), 12},
  };
  for (const Crystal& crystal : table) {
    const double edge = crystal.edge * (1 - 1e-9);
    std::string lattice;
    std::istringstream numbers(crystal.lattice);
    for (double number = 0; numbers >> number;) lattice += fmt::format("{} ", number * edge);
    write_file(runs.path("a.xyz"),
               fmt::format("\xEF\xBB\xBF"
                           "1\r\nLattice=\"{}\" pbc=\"T T T\" "
                           "Properties=species:S:1:pos:R:3:radius:R:1\r\nCu 0 0 0 0.5\r\n",
                           lattice));
    ASSERT_EQ(furnas({"analyze", runs.path("a.xyz"), "--out", runs.path("out"), "--no-pictures"}).code,
              ExitCode::done)
        << crystal.name;
    const auto json = nlohmann::json::parse(content(runs.path("out/analysis.json")));
    EXPECT_NEAR(json["phi"].get<double>(), crystal.phi, 1e-8) << crystal.name;
    EXPECT_EQ(json["network"]["coordination"]["Z"], crystal.coordination) << crystal.name;
    EXPECT_EQ(json["pair_correlation"].size(), 1u) << crystal.name;
  }
}

/// Few spheres have no backbone, many images of themselves, and lists shorter than a batch.
TEST(FilesOfOthers, OneToTenSpheresAreAnalyzedAndRun) {
  const Runs runs;
  for (int spheres = 1; spheres <= 10; ++spheres) {
    std::string file = fmt::format(
        "{}\nLattice=\"{} 0 0 0 1.2 0 0 0 1.2\" Properties=species:S:1:pos:R:3:radius:R:1:velo:R:3\n",
        spheres, 1.2 * spheres);
    for (int k = 0; k < spheres; ++k) file += fmt::format("A {} 0.6 0.6 0.5 0.01 0.02 0.03\n", 0.6 + 1.2 * k);
    write_file(runs.path("few.xyz"), file);
    const Answer looked =
        furnas({"analyze", runs.path("few.xyz"), "--out", runs.path("out"), "--no-pictures"});
    ASSERT_EQ(looked.code, ExitCode::done) << spheres << looked.err;
    const auto json = nlohmann::json::parse(content(runs.path("out/analysis.json")));
    EXPECT_NEAR(json["phi"].get<double>(), std::numbers::pi / 6 / (1.2 * 1.2 * 1.2), 1e-12) << spheres;
    EXPECT_FALSE(json.contains("network")) << spheres << ": nothing touches";
    write_file(runs.path("few.toml"),
               with_replaced(with_replaced(fixed_case, "dens.data", "few.xyz"), "2000", "200"));
    const std::string run = runs.path(fmt::format("run{}", spheres));
    EXPECT_EQ(furnas({"run", runs.path("few.toml"), "--out", run}).code, ExitCode::budget_spent) << spheres;
    const auto result = nlohmann::json::parse(content(run + "/result.json"));
    EXPECT_EQ(result["particles"], spheres);
  }
}

TEST(FilesOfOthers, ChainsAreDrawnOfOverlaps) {
  const Runs runs;
  write_file(runs.path("fcc.xyz"), crystal());
  const Answer answer = furnas({"render", runs.path("fcc.xyz"), "--style", "chains", "--size", "64", "--out",
                                runs.path("chains.png")});
  EXPECT_EQ(answer.code, ExitCode::done) << answer.err;
}

TEST(FilesOfOthers, OptionsRefuseWhatIsNotFinite) {
  const Runs runs;
  write_file(runs.path("fcc.xyz"), crystal());
  const std::vector<std::string> file{runs.path("fcc.xyz")};
  const std::vector<std::vector<std::string>> table{
      {"render", file[0], "--turn", "nan"},
      {"certify", file[0], "--pressure", "1e-4", "--force-imbalance", "nan"},
      {"certify", file[0], "--pressure", "inf"},
      {"analyze", file[0], "--reach", "nan"},
      {"import", file[0], "--scale", "nan"},
  };
  for (const auto& arguments : table) {
    const Answer answer = furnas(arguments);
    EXPECT_EQ(answer.code, ExitCode::bad_case) << arguments[0];
    EXPECT_THAT(answer.err, HasSubstr("not finite")) << arguments[0];
  }
}

}  // namespace
}  // namespace furnas
