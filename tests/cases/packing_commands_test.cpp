#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cases/program/run/recording.h"
#include "io/formats.h"
#include "tests/cases/runs.h"

namespace furnas {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// Bytes that begin a PNG file.
constexpr std::string_view png = "\x89PNG\r\n\x1a\n";

TEST(Export, WritesEachFormatFromTheFolderOfARun) {
  const Runs runs;
  ASSERT_EQ(runs.run("a", {"stop.steps=2000"}).code, ExitCode::budget_spent);
  const Packing packing = read_packing(runs.path("a/b.checkpoint"));
  ASSERT_EQ(packing.step, 2000);
  int read_back = 0;
  for (const Format& format : formats()) {
    if (!format.write) continue;
    const std::string out = runs.path("exported" + std::string(extension_of(format.name)));
    const Answer answer = furnas({"export", runs.path("a"), std::string(format.name), "--out", out});
    ASSERT_EQ(answer.code, ExitCode::done) << answer.err;
    EXPECT_EQ(answer.out, out + "\n");
    ASSERT_TRUE(fs::exists(out));
    if (!format.read && !format.read_frame) continue;
    expect_same_packing(packing, read_packing(out));
    ++read_back;
  }
  EXPECT_EQ(read_back, 4);
}

/// From format to format and back it is the same packing.
TEST(Import, KeepsThePackingThroughEveryFormat) {
  const Runs runs;
  const Packing packing = random_packing(7);
  write_packing(packing, "vtp", runs.path("start.vtp"));
  std::string from = runs.path("start.vtp");
  for (const char* extension : {".data", ".lammpstrj", ".extxyz", ".vtp"}) {
    const std::string to = runs.path("next" + std::string(extension));
    const Answer answer = furnas({"import", from, "--out", to});
    ASSERT_EQ(answer.code, ExitCode::done) << answer.err;
    EXPECT_THAT(answer.out, HasSubstr(to + "\n"));
    from = to;
  }
  expect_same_packing(packing, read_packing(from));
}

TEST(Import, SaysWhatItIs) {
  const Runs runs;
  const Answer answer = furnas({"import", test_data("a3.data")});
  ASSERT_EQ(answer.code, ExitCode::done);
  EXPECT_THAT(answer.out,
              testing::MatchesRegex("320 particles, [0-9]+ large, packing fraction 0\\.[0-9]+\n"));
  EXPECT_EQ(runs.files(), 1u) << "it only describes";
}

TEST(PackingCommands, NameTheFormatsThatTheyKnow) {
  const Runs runs;
  write_packing(random_packing(1), "vtp", runs.path("a.vtp"));
  write_file(runs.path("a.txt"), "hello\n");
  struct Wrong {
    std::vector<std::string> arguments;
    const char* says;
  };
  const Wrong table[] = {
      {{"export", runs.path("a.vtp"), "pdb"}, "'pdb' is no format to write; allowed are lammps-data"},
      {{"export", runs.path("none"), "vtp"}, "none"},
      {{"import", runs.path("a.txt")}, "neither its content nor its extension determines the format"},
      {{"import", runs.path("a.vtp"), "--out", runs.path("b.pdb")},
       "its extension belongs to no format that can be written"},
      {{"import", runs.path("none.vtp")}, "none.vtp"},
      {{"render", runs.path("a.txt"), "--out", runs.path("a.png")}, "neither its content nor its extension"},
      {{"render", runs.path("a.vtp"), "--size", "3"}, "--size"},
      {{"render", runs.path("a.vtp"), "--slice", "z=0.6:0.4"}, "two fractions of that edge, like z=0.4:0.6"},
      {{"render", runs.path("a.vtp"), "--style", "fog"}, "{chains,fig1a}"},
      {{"render", runs.path("a.vtp"), "--style", "chains", "--times", "2x1x1"},
       "chains are drawn of one cell"},
      {{"render", runs.path("a.vtp"), "--compaction"}, "no frames.pvd in it"},
  };
  const std::size_t files = runs.files();
  for (const Wrong& wrong : table) {
    const Answer answer = furnas(wrong.arguments);
    EXPECT_EQ(answer.code, ExitCode::bad_case) << wrong.says;
    EXPECT_THAT(answer.err, HasSubstr(wrong.says));
    EXPECT_EQ(runs.files(), files) << wrong.says;
  }
}

TEST(Export, SaysWhichCheckpointIsTheOlder) {
  const Runs runs;
  ASSERT_EQ(runs.run("a", {"stop.steps=10"}).code, ExitCode::budget_spent);
  const auto err_of = [&](const std::string& source) {
    return furnas({"export", runs.path(source), "extxyz", "--out", runs.path("out.extxyz")}).err;
  };
  const bool newest_is_a = Checkpoints::find_newest(runs.path("a")).file == "a.checkpoint";
  const std::string newest = newest_is_a ? "a/a.checkpoint" : "a/b.checkpoint";
  const std::string older = newest_is_a ? "a/b.checkpoint" : "a/a.checkpoint";
  EXPECT_THAT(err_of(newest), testing::Not(HasSubstr("older")));
  EXPECT_THAT(err_of("a"), testing::Not(HasSubstr("older")));
  EXPECT_THAT(err_of(older), HasSubstr("is the older of two checkpoints"));
}

TEST(Render, DrawsAFileAndTheFolderOfARun) {
  const Runs runs;
  ASSERT_EQ(runs.run("a", {"stop.steps=10"}).code, ExitCode::budget_spent);
  for (const char* from : {"a", "a/packing.vtp"}) {
    const std::string out = runs.path("picture.png");
    const Answer answer = furnas({"render", runs.path(from), "--out", out, "--size", "64", "--transparent"});
    ASSERT_EQ(answer.code, ExitCode::done) << answer.err;
    EXPECT_EQ(content(out).substr(0, png.size()), png);
    fs::remove(out);
  }
}

TEST(Render, DrawsTheFramesOfARunAndTurnsAround) {
  const Runs runs;
  ASSERT_EQ(runs.run("a", {"stop.steps=20", "output.snapshot_every=10"}).code, ExitCode::budget_spent);
  const auto pictures = [&](const std::vector<std::string>& how) {
    std::vector<std::string> arguments{"render", runs.path("a"), "--out", runs.path("p.png"), "--size", "64"};
    arguments.insert(arguments.end(), how.begin(), how.end());
    EXPECT_EQ(furnas(arguments).code, ExitCode::done);
    int count = 0;
    for (; fs::exists(runs.path(fmt::format("p_{:04}.png", count))); ++count)
      fs::remove(runs.path(fmt::format("p_{:04}.png", count)));
    return count;
  };
  EXPECT_EQ(pictures({"--compaction"}), 3) << "the start, and the end that is a frame already";
  EXPECT_EQ(pictures({"--turning", "3", "--colour", "rattlers"}), 3);
}

TEST(Run, DrawsItsPicture) {
  const Runs runs;
  ASSERT_EQ(runs.run("a", {"stop.steps=10", "output.picture=fig1a", "output.picture_size=64"}).code,
            ExitCode::budget_spent);
  EXPECT_EQ(content(runs.path("a/packing.png")).substr(0, png.size()), png);
}

TEST(Check, ReportsAndRefuses) {
  const Runs runs;
  const Answer good = furnas({"check", runs.path("case.toml")});
  EXPECT_EQ(good.code, ExitCode::done);
  EXPECT_THAT(good.out, HasSubstr("particles 100"));
  const Answer refused = furnas({"check", runs.path("case.toml"), "--set", "mixture.size_ratio=100", "--set",
                                 "mixture.small_fraction=0.5", "--set", "mixture.large=2000"});
  EXPECT_EQ(refused.code, ExitCode::refused);
  EXPECT_THAT(refused.err, HasSubstr("refused: the run needs about"));
  EXPECT_EQ(furnas({"check", runs.path("none.toml")}).code, ExitCode::bad_case);
  EXPECT_EQ(runs.files(), 1u);
}

}  // namespace
}  // namespace furnas
