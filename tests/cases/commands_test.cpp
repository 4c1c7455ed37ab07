#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include "cases/program/case_templates.h"
#include "cases/program/program.h"
#include "io/case_file.h"
#include "io/case_schema.h"
#include "io/sweep_file.h"
#include "io/tradeoff_file.h"

namespace furnas {
Command new_command();
Command schema_command();
Command info_command();

namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

std::string read_all(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

/// Runs commands in an empty folder of its own.
class Commands : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::temp_directory_path() / (std::string("furnas_") + test->name() + std::to_string(getpid()));
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  ExitCode furnas(const std::vector<std::string>& arguments) {
    const std::vector<Command> commands = {new_command(), schema_command(), info_command()};
    std::ostringstream out;
    std::ostringstream err;
    const ExitCode code = run_program(commands, arguments, {out, err});
    out_ = out.str();
    err_ = err.str();
    return code;
  }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  fs::path folder_;
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
  EXPECT_EQ(read_all(path("mine.toml")), "mine");
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
    EXPECT_EQ(known.text, read_all(file)) << file;
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
  EXPECT_EQ(out_, read_all(fs::path(FURNAS_SOURCE_DIR) / "docs/reference/case-file.md"))
      << "run: ./furnas schema --markdown > docs/reference/case-file.md";
}

TEST_F(Commands, InfoNamesTheBuild) {
  ASSERT_EQ(furnas({"info"}), ExitCode::done);
  for (const char* what : {"furnas", "compiler", "build type", "flags", "threads", "oneTBB", "VTK", "toml++"})
    EXPECT_THAT(out_, HasSubstr(what));
}

}  // namespace
}  // namespace furnas
