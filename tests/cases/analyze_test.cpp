#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <numbers>

#include "cases/program/packing_source.h"
#include "engine/base/require.h"
#include "io/checkpoint.h"
#include "io/formats.h"
#include "tests/cases/runs.h"

namespace furnas {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

/// Small spheres at rest in a cube.
Packing spheres_at(double edge, const std::vector<Vec3<double>>& places) {
  Packing p;
  p.cell.edges = {edge, edge, edge, 0, 0, 0};
  p.resize(places.size());
  for (std::size_t k = 0; k < places.size(); ++k) {
    p.species[k] = Species::small;
    p.radius[k] = 0.5;
    p.mass[k] = std::numbers::pi / 6;
    p.fraction[k] = to_fraction((1 / edge) * places[k]);
  }
  return p;
}

nlohmann::json json_of(const Runs& runs, const std::string& name) {
  return nlohmann::json::parse(content(runs.path(name)));
}

/// The whole way on a packing that jams in a second: its folder, and what its files say.
TEST(Analyze, OfARunAgreesWithItsResult) {
  const Runs runs;
  ASSERT_EQ(runs.run("a").code, ExitCode::done);
  const auto result = runs.result("a");
  const Answer answer = furnas({"analyze", runs.path("a")});
  ASSERT_EQ(answer.code, ExitCode::done) << answer.err;
  for (const char* file :
       {"analysis.json", "coordination.csv", "rattlers.csv", "forces.csv", "mobilisation.csv", "fabric.csv",
        "pair_correlation.csv", "normal_forces.png", "normal_forces.svg", "tangential_forces.svg",
        "mobilisation.png", "rattlers.png", "pair_correlation.svg"}) {
    EXPECT_GT(fs::file_size(runs.path(std::string("a/") + file)), 100U) << file;
    EXPECT_THAT(answer.out, HasSubstr(file));
  }
  const auto analysis = json_of(runs, "a/analysis.json");
  EXPECT_EQ(analysis["phi_J"], result["phi_J"]);
  EXPECT_EQ(analysis["phi"], result["phi"]);
  EXPECT_EQ(analysis["friction"], 0.3) << "from the case of the run";
  EXPECT_EQ(analysis["network"]["coordination"]["Z"], result["Z"]);
  EXPECT_EQ(analysis["network"]["backbone_coordination"]["Z"], result["Z_backbone"]);
  EXPECT_EQ(analysis["network"]["backbone_threshold"], result["backbone_threshold"]);
  for (const auto& counted : result["rattlers"])
    for (const auto& row : analysis["network"]["rattlers"])
      if (row["least_contacts"] == counted["least_contacts"] && row["live_force_share"] == 0.01) {
        EXPECT_EQ(row["large"], counted["large"]);
      }
  EXPECT_THAT(answer.out, HasSubstr("(phi_J: jammed)"));
  EXPECT_THAT(answer.out, Not(HasSubstr("exceed this friction")));
}

/// A checkpoint knows its case, wherever it lies.
TEST(Analyze, OfACheckpointGoesIntoTheFolderThatIsNamed) {
  const Runs runs;
  ASSERT_EQ(runs.run("a", {"stop.steps=3000"}).code, ExitCode::budget_spent);
  const Answer answer =
      furnas({"analyze", runs.path("a/b.checkpoint"), "--out", runs.path("seen/here"), "--no-pictures",
              "--friction", "0.1", "--backbone", "2", "--reach", "2", "--bin", "0.1", "--logarithmic"});
  ASSERT_EQ(answer.code, ExitCode::done) << answer.err;
  EXPECT_FALSE(fs::exists(runs.path("seen/here/rattlers.png")));
  const auto analysis = json_of(runs, "seen/here/analysis.json");
  EXPECT_EQ(analysis["friction"], 0.1);
  EXPECT_EQ(analysis["network"]["backbone_threshold"], 2);
  EXPECT_TRUE(analysis["phi_J"].is_null());
  EXPECT_NEAR(analysis["pair_correlation"][0]["reach"].get<double>(), 2, 1e-12);
  EXPECT_NEAR(analysis["pair_correlation"][0]["bin"].get<double>(), 0.1, 1e-12);
  EXPECT_THAT(content(runs.path("seen/here/forces.csv")), HasSubstr("normal,all,"));
  EXPECT_EQ(packing_source(runs.path("a/b.checkpoint")).of_case->contact.friction, 0.3);
}

TEST(FolderAbout, IsTheOneNamedOrThatOfThePacking) {
  const Runs runs;
  fs::create_directory(runs.path("run"));
  EXPECT_EQ(folder_about(runs.path("run"), ""), runs.path("run"));
  EXPECT_EQ(folder_about(runs.path("run/a.data"), ""), runs.path("run"));
  EXPECT_EQ(folder_about("a.data", ""), ".");
  EXPECT_EQ(folder_about(runs.path("run"), runs.path("new/here")), runs.path("new/here"));
  EXPECT_TRUE(fs::is_directory(runs.path("new/here")));
  write_file(runs.path("file"), "");
  EXPECT_THROW(folder_about(runs.path("run"), runs.path("file")), InputError);
}

/// A file with positions alone: overlaps are its contacts, and it says so.
TEST(Analyze, OfPositionsTakesOverlapsForContacts) {
  const Runs runs;
  ASSERT_EQ(runs.run("a").code, ExitCode::done);
  const Packing packing = read_packing(runs.path("a/b.checkpoint"));
  write_packing(packing, "lammps-data", runs.path("a.data"));
  const Answer answer =
      furnas({"analyze", runs.path("a.data"), "--out", runs.path("out"), "--friction", "0.3"});
  ASSERT_EQ(answer.code, ExitCode::done) << answer.err;
  EXPECT_THAT(answer.out, HasSubstr("overlaps take their place"));
  EXPECT_FALSE(fs::exists(runs.path("out/mobilisation.csv"))) << "overlaps tell nothing of tangential forces";
  ASSERT_EQ(furnas({"analyze", runs.path("a"), "--no-pictures"}).code, ExitCode::done);
  const auto found = json_of(runs, "out/analysis.json"), known = json_of(runs, "a/analysis.json");
  EXPECT_EQ(found["contacts_are"], "overlaps");
  EXPECT_EQ(known["contacts_are"], "of the source");
  EXPECT_EQ(found["network"]["coordination"]["contacts"], known["network"]["coordination"]["contacts"]);
  const auto mean = [](const auto& json) {
    return json["network"]["backbone"][0]["mean_normal_force"].template get<double>();
  };
  // Damping of what still moves in the run: a hundredth of the forces.
  EXPECT_NEAR(mean(found), mean(known), 0.01 * mean(known));
}

// The case of a run may name a start that is gone.
TEST(Analyze, OfAPackingWhoseStartIsGone) {
  const Runs runs("[stop]\nsteps = 10\n[output]\npicture = \"none\"\n");
  const std::string start = runs.path("start.vtp");
  ASSERT_EQ(runs.run("first", {"mixture.large=100"}).code, ExitCode::budget_spent);
  fs::copy_file(runs.path("first/packing.vtp"), start);
  ASSERT_EQ(runs.run("second", {"start.file=" + start}).code, ExitCode::budget_spent);
  fs::remove(start);
  EXPECT_EQ(furnas({"analyze", runs.path("second/packing.vtp")}).code, ExitCode::done);
}

TEST(Analyze, OfAGasHasPairsAlone) {
  const Runs runs;
  const Packing gas = spheres_at(20, {{1, 1, 1}, {5, 5, 5}, {9, 1, 9}});
  write_packing(gas, "vtp", runs.path("gas.vtp"));
  const Answer answer = furnas({"analyze", runs.path("gas.vtp"), "--out", runs.path("out")});
  ASSERT_EQ(answer.code, ExitCode::done) << answer.err;
  EXPECT_THAT(answer.out, HasSubstr("no two spheres overlap"));
  EXPECT_TRUE(fs::exists(runs.path("out/pair_correlation.png")));
  EXPECT_FALSE(fs::exists(runs.path("out/rattlers.csv")));
}

TEST(OverlapsAsContacts, PushWithTheirOverlapAlone) {
  Packing pair = spheres_at(10, {{1, 5, 5}, {1.8, 5, 5}});
  pair.velocity = {{0.3, 0.1, 0}, {-0.3, 0, 0.2}};
  pair.spin[0] = {0, 0, 5};
  pair.cell.rate = {0.1, 0, 0, 0, 0, 0.1};
  pair.force[0] = {7, 7, 7};
  const Packing found = with_overlaps_as_contacts(pair);
  ASSERT_EQ(found.contacts.size(), 1U);
  const Contact& c = found.contacts[0];
  EXPECT_NEAR(c.overlap, 0.2, 1e-15);
  EXPECT_NEAR(norm(c.force), 0.2, 1e-15) << "no damping, no friction";
  EXPECT_NEAR(dot(c.force, c.branch), 0.2 * 0.8, 1e-15) << "along the normal";
}

TEST(Analyze, RefusesWhatItCannotUse) {
  const Runs runs;
  write_packing(random_packing(1), "vtp", runs.path("a.vtp"));
  struct Wrong {
    std::vector<std::string> arguments;
    const char* says;
  };
  const std::vector<std::string> command{"analyze", runs.path("a.vtp"), "--out", runs.path("out")};
  const Wrong table[] = {
      {{"--friction", "-1"}, "--friction"},
      {{"--backbone", "5"}, "--backbone"},
      {{"--reach", "0"}, "--reach"},
      {{"--reach", "1e6"}, "the reach of g(r) is"},
      {{"--bin", "1e-9"}, "the bins of g(r) are"},
      {{"--force-bin", "0"}, "--force-bin"},
  };
  for (const Wrong& wrong : table) {
    std::vector<std::string> arguments = command;
    arguments.insert(arguments.end(), wrong.arguments.begin(), wrong.arguments.end());
    const Answer answer = furnas(arguments);
    EXPECT_EQ(answer.code, ExitCode::bad_case) << wrong.says;
    EXPECT_THAT(answer.err, HasSubstr(wrong.says));
    EXPECT_FALSE(fs::exists(runs.path("out"))) << wrong.says;
  }
  EXPECT_EQ(furnas({"analyze", runs.path("none")}).code, ExitCode::bad_case);
  write_file(runs.path("file"), "");
  EXPECT_THAT(furnas({"analyze", runs.path("a.vtp"), "--out", runs.path("file")}).err,
              HasSubstr("cannot be made"));
}

}  // namespace
}  // namespace furnas
