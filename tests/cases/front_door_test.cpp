#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <future>
#include <string>

namespace furnas {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

struct ShellAnswer {
  int code;
  std::string text;  ///< stdout and stderr
};

ShellAnswer shell(const std::string& command) {
  ShellAnswer answer{};
  std::FILE* pipe = popen(("exec 2>&1; " + command).c_str(), "r");
  for (int letter = std::fgetc(pipe); letter != EOF; letter = std::fgetc(pipe))
    answer.text += static_cast<char>(letter);
  const int status = pclose(pipe);
  answer.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return answer;
}

void write(const fs::path& file, const std::string& text) {
  fs::create_directories(file.parent_path());
  std::ofstream(file) << text;
}

void write_script(const fs::path& file, const std::string& text) {
  write(file, "#!/bin/sh\n" + text + "\n");
  fs::permissions(file, fs::perms::owner_all);
}

const fs::path checkout = FURNAS_SOURCE_DIR;

/// A folder that no other test, nor the same test of another checkout, uses. Its blank is meant.
fs::path own_folder(const std::string& name) {
  return fs::temp_directory_path() / ("furnas door " + name + std::to_string(getpid()));
}

/// A checkout with the real front door and a program of one line behind it.
class FrontDoor : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    root_ = own_folder(test->name());
    fs::remove_all(root_);
    fs::create_directories(root_ / "elsewhere");
    fs::copy_file(checkout / "furnas", root_ / "furnas");
    fs::copy_file(checkout / "CMakePresets.json", root_ / "CMakePresets.json");
    write(root_ / "packages.txt", "# none\n");
    write(root_ / "CMakeLists.txt",
          "cmake_minimum_required(VERSION 3.25)\nproject(door C)\noption(FURNAS_TESTS \"\" ON)\n"
          "add_executable(furnas furnas.c)\n"
          "if(FURNAS_TESTS)\n enable_testing()\n add_test(NAME good COMMAND furnas)\n"
          " add_test(NAME bad COMMAND furnas a b c d)\n"
          " set_tests_properties(good PROPERTIES LABELS commit)\n"
          " set_tests_properties(bad PROPERTIES LABELS nightly)\nendif()\n");
    write_program("program");
  }
  void TearDown() override { fs::remove_all(root_); }

  /// A program that prints `word` and its arguments, and returns their number.
  void write_program(const std::string& word) {
    write(root_ / "furnas.c",
          "#include <stdio.h>\nint main(int n, char** a) { printf(\"" + word +
              "\"); for (int i = 1; i < n; ++i) printf(\"<%s>\", a[i]); return n - 1; }\n");
  }

  /// Calls the front door from another folder.
  ShellAnswer door(const std::string& arguments, const std::string& setting = "") {
    return shell("cd '" + (root_ / "elsewhere").string() + "' && " + setting + " ../furnas " + arguments);
  }

  fs::path root_;
};

TEST_F(FrontDoor, BuildsThenBecomesTheProgram) {
  const ShellAnswer first = door("'a b' case.toml");
  EXPECT_EQ(first.code, 2);
  EXPECT_EQ(first.text, "furnas: configuring ...\nfurnas: building ...\nprogram<a b><case.toml>");
  const ShellAnswer second = door("");
  EXPECT_EQ(second.code, 0);
  EXPECT_EQ(second.text, "program");

  // A clock that stands still between two writes would hide the change.
  write_program("changed");
  fs::last_write_time(root_ / "furnas.c", fs::file_time_type::clock::now() + std::chrono::seconds(2));
  EXPECT_EQ(door("").text, "furnas: building ...\nchanged");
}

TEST_F(FrontDoor, SaysWhyTheBuildFailed) {
  write(root_ / "furnas.c", "int main(void) { return nothing; }\n");
  const ShellAnswer answer = door("");
  EXPECT_EQ(answer.code, 1);
  EXPECT_THAT(answer.text, HasSubstr("nothing"));
  EXPECT_THAT(answer.text, HasSubstr("build/release/build.log"));
}

TEST_F(FrontDoor, TwoCallsAtOnceShareOneBuild) {
  auto other = std::async(std::launch::async, [&] { return door("one"); });
  const ShellAnswer mine = door("two");
  EXPECT_EQ(mine.code, 1);
  EXPECT_THAT(mine.text, HasSubstr("program<two>"));
  EXPECT_THAT(other.get().text, HasSubstr("program<one>"));
}

TEST_F(FrontDoor, MovedCheckoutIsConfiguredAnew) {
  ASSERT_EQ(door("").code, 0);
  const fs::path moved = root_.string() + " moved";
  fs::remove_all(moved);
  fs::rename(root_, moved);
  root_ = moved;
  const ShellAnswer answer = door("");
  EXPECT_EQ(answer.code, 0);
  EXPECT_THAT(answer.text, HasSubstr("program"));
}

TEST_F(FrontDoor, TestRunsTheCommitLabelAndCarriesItsCode) {
  for (const char* room : {"engine", "io", "viz", "cases", "tests"}) fs::create_directories(root_ / room);
  const ShellAnswer commit = door("test");
  EXPECT_EQ(commit.code, 0) << commit.text;
  EXPECT_THAT(commit.text, HasSubstr("tests: 1 passed, 0 failed"));
  const ShellAnswer nightly = door("test -L nightly");
  EXPECT_NE(nightly.code, 0);
  EXPECT_THAT(nightly.text, HasSubstr("tests: 0 passed, 1 failed"));
  EXPECT_NE(door("test -R nothing").code, 0);
  EXPECT_EQ(door("").text, "program");
}

TEST_F(FrontDoor, TestFailsOnAForeignFormat) {
  if (shell("command -v clang-format").code != 0) GTEST_SKIP() << "clang-format is not installed";
  for (const char* room : {"engine", "io", "viz", "cases", "tests"}) fs::create_directories(root_ / room);
  write(root_ / "io/odd.cpp", "int  odd ( );\n");
  const ShellAnswer answer = door("test");
  EXPECT_EQ(answer.code, 1);
  EXPECT_THAT(answer.text, HasSubstr("format: not clang-format's: io/odd.cpp"));
}

TEST_F(FrontDoor, TestFailsIfTheFormatCannotBeChecked) {
  for (const char* room : {"engine", "io", "viz", "cases", "tests"}) fs::create_directories(root_ / room);
  write(root_ / "io/odd.cpp", "int odd();\n");
  write_script(root_ / "bin/clang-format", "echo no such style >&2; exit 1");
  const ShellAnswer answer = door("test", "PATH=\"" + (root_ / "bin").string() + ":$PATH\"");
  EXPECT_EQ(answer.code, 1);
  EXPECT_THAT(answer.text, HasSubstr("format: clang-format failed:\nno such style"));
}

/// Commands that stand in for Debian's: nothing is installed, and what is asked for is written down.
class FrontDoorPackages : public FrontDoor {
 protected:
  void SetUp() override {
    FrontDoor::SetUp();
    write(root_ / "packages.txt", "# tools\nhere\nlibabsent-dev\n");
    write_script(root_ / "bin/dpkg-query", "case $* in *here*) printf installed ;; *) exit 1 ;; esac");
    write_script(root_ / "bin/apt-get", "echo \"$*\" >>'" + asked().string() + "'");
  }
  fs::path asked() const { return root_ / "asked"; }
  std::string asked_text() const { return shell("cat '" + asked().string() + "'").text; }
  std::string with_path() const { return "PATH=\"" + (root_ / "bin").string() + ":$PATH\""; }
};

TEST_F(FrontDoorPackages, InstallsOnlyWhatIsMissingAndOnlyOnce) {
  write_script(root_ / "bin/id", "echo 0");
  const ShellAnswer answer = door("", with_path());
  EXPECT_EQ(answer.code, 0) << answer.text;
  EXPECT_THAT(answer.text, HasSubstr("furnas: installing libabsent-dev ..."));
  EXPECT_EQ(asked_text(), "update\ninstall -y --no-install-recommends libabsent-dev\n");
  EXPECT_EQ(door("", with_path()).text, "program");
  EXPECT_EQ(asked_text(), "update\ninstall -y --no-install-recommends libabsent-dev\n");
}

TEST_F(FrontDoorPackages, UsesSudoWhenNotRoot) {
  write_script(root_ / "bin/id", "echo 1000");
  write_script(root_ / "bin/sudo", "echo sudo >>'" + asked().string() + "'; \"$@\"");
  EXPECT_EQ(door("", with_path()).code, 0);
  EXPECT_EQ(asked_text(), "sudo\nupdate\nsudo\ninstall -y --no-install-recommends libabsent-dev\n");
}

TEST_F(FrontDoorPackages, SaysWhatIsMissingWithoutRootOrSudo) {
  write_script(root_ / "bin/id", "echo 1000");
  // A path with the few tools that are needed so far, and no sudo.
  for (const char* tool : {"sh", "sed", "tr", "cmp", "cp", "mkdir", "flock", "dirname", "readlink"})
    write_script(root_ / "bin" / tool, "exec /usr/bin/" + std::string(tool) + " \"$@\"");
  const ShellAnswer answer = door("", "PATH='" + (root_ / "bin").string() + "'");
  EXPECT_EQ(answer.code, 1);
  EXPECT_THAT(answer.text, HasSubstr("apt-get install libabsent-dev"));
  EXPECT_FALSE(fs::exists(asked()));
}

TEST(FrontDoorScript, IsPlainShell) {
  EXPECT_EQ(shell("sh -n '" + (checkout / "furnas").string() + "'").text, "");
  if (shell("command -v shellcheck").code != 0) GTEST_SKIP() << "shellcheck is not installed";
  EXPECT_EQ(
      shell("shellcheck '" + (checkout / "furnas").string() + "' '" + (checkout / ".ci/run").string() + "'")
          .text,
      "");
}

TEST(NightlyFrontDoor, WorksInACleanClone) {
  const fs::path clone = own_folder("clone");
  fs::remove_all(clone);
  const ShellAnswer cloned = shell("git clone -q '" + checkout.string() + "' '" + clone.string() + "'");
  ASSERT_EQ(cloned.code, 0) << cloned.text;
  const ShellAnswer answer = shell("cd / && '" + (clone / "furnas").string() + "' info");
  EXPECT_EQ(answer.code, 0) << answer.text;
  EXPECT_THAT(answer.text, HasSubstr("compiler"));
  fs::remove_all(clone);
}

}  // namespace
}  // namespace furnas
