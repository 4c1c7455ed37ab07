#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "cases/program/case_templates.h"
#include "io/case_file.h"
#include "io/case_schema.h"
#include "io/sweep_file.h"
#include "io/tradeoff_file.h"
#include "tests/cases/runs.h"

namespace furnas {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// Runs commands in an empty folder of its own.
class Commands : public testing::Test {
 protected:
  ExitCode furnas(const std::vector<std::string>& arguments) {
    Answer answer = ::furnas::furnas(arguments);
    out_ = std::move(answer.out);
    err_ = std::move(answer.err);
    return answer.code;
  }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  const TemporaryFolder folder_;
  std::string out_, err_;
};

TEST_F(Commands, NewWritesACaseThatReads) {
  for (const char* name : {"mono", "frictionless", "bidisperse", "paper", "smoke"}) {
    const std::string file = path(std::string(name) + ".toml");
    EXPECT_EQ(furnas({"new", name, file}), ExitCode::done) << err_;
    EXPECT_THAT(out_, HasSubstr("furnas run " + file));
    EXPECT_NO_THROW(read_case(file)) << name;
  }
}

TEST_F(Commands, NewNeverOverwrites) {
  std::ofstream(path("mine.toml")) << "mine";
  EXPECT_EQ(furnas({"new", "mono", path("mine.toml")}), ExitCode::bad_case);
  EXPECT_THAT(err_, HasSubstr("mine.toml exists"));
  EXPECT_EQ(content(path("mine.toml")), "mine");
}

TEST_F(Commands, NewRefusesUnknownTemplatesAndPlaces) {
  EXPECT_EQ(furnas({"new", "momo", path("momo.toml")}), ExitCode::bad_case);
  EXPECT_THAT(err_, HasSubstr("mono, frictionless, bidisperse, paper, smoke"));
  EXPECT_FALSE(fs::exists(path("momo.toml")));
  EXPECT_EQ(furnas({"new", "mono", path("no/such/folder.toml")}), ExitCode::output_failed);
  EXPECT_THAT(err_, HasSubstr("cannot create the file"));
}

TEST_F(Commands, TemplatesAreTheCaseFiles) {
  std::size_t files = 0;
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(FURNAS_SOURCE_DIR) / "cases"))
    if (entry.path().extension() == ".toml") ++files;
  EXPECT_EQ(case_templates().size(), files);
  for (const CaseTemplate& known : case_templates()) {
    const auto file = fs::path(FURNAS_SOURCE_DIR) / "cases" / (std::string(known.file) + ".toml");
    EXPECT_EQ(known.text, content(file)) << file;
    EXPECT_THAT(std::string(known.text), HasSubstr("# Expect: ")) << "a case says what to expect";
    if (known.file.starts_with("tradeoff")) {
      EXPECT_NO_THROW(read_tradeoff(file)) << file;
    } else if (holds_sweep(file)) {
      EXPECT_NO_THROW(read_sweep(file)) << file;
    } else {
      EXPECT_NO_THROW(read_case(file)) << file;
    }
  }
}

TEST_F(Commands, SchemaListsEveryKey) {
  ASSERT_EQ(furnas({"schema"}), ExitCode::done);
  for (const Key& key : case_keys()) EXPECT_THAT(out_, HasSubstr("  " + std::string(key.name) + " = "));
  EXPECT_THAT(out_, HasSubstr("real or \"auto\" in t_c; allowed: \"auto\" or 0 < time_step <= 0.2"));
}

TEST_F(Commands, TheReferencePageIsWhatSchemaWrites) {
  ASSERT_EQ(furnas({"schema", "--markdown"}), ExitCode::done);
  EXPECT_EQ(out_, content(fs::path(FURNAS_SOURCE_DIR) / "docs/reference/case-file.md"))
      << "run: ./furnas schema --markdown > docs/reference/case-file.md";
}

TEST_F(Commands, InfoNamesTheBuild) {
  ASSERT_EQ(furnas({"info"}), ExitCode::done);
  for (const char* what : {"furnas", "compiler", "build type", "flags", "threads", "oneTBB", "VTK", "toml++"})
    EXPECT_THAT(out_, HasSubstr(what));
}

}  // namespace
}  // namespace furnas
