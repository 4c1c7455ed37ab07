#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <cerrno>
#include <csignal>
#include <iostream>
#include <map>
#include <sstream>
#include <thread>

#include "cases/program/run/recording.h"
#include "tests/cases/process.h"
#include "tests/cases/runs.h"
#include "tests/cases/same_run.h"

namespace furnas {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr const char* small_case = R"([mixture]
large = 20
start_fraction = 0.2
[stop]
steps = 240
[compute]
threads = 1
[output]
history_every = 20
snapshot_every = 60
picture = "none"
)";

/// How the faults of one sweep show themselves.
struct Fault {
  const char* name;
  int error;   ///< 0: the process is killed
  bool lasts;  ///< later calls that need room fail, too
};

std::map<std::string, std::string> failing(const fs::path& folder, long at, const Fault& fault,
                                           const fs::path& count) {
  std::map<std::string, std::string> setting{{"LD_PRELOAD", FURNAS_IO_FAULTS},
                                             {"ASAN_OPTIONS", "verify_asan_link_order=0"},
                                             {"FURNAS_FAULT_UNDER", folder.string()},
                                             {"FURNAS_FAULT_AT", std::to_string(at)},
                                             {"FURNAS_FAULT_ERROR", std::to_string(fault.error)},
                                             {"FURNAS_FAULT_COUNT", count.string()}};
  if (fault.lasts) setting["FURNAS_FAULT_LASTS"] = "1";
  return setting;
}

/// What a process may say that met a fault: one line, and the code that goes with it.
void expect_plain_sentence(const Ending& ending, const std::string& where) {
  EXPECT_EQ(ending.signal, 0) << where << ending.out;
  EXPECT_TRUE(ending.code == 5 || ending.code == 7 || ending.code == 2) << where << ending.code << ending.out;
  if (ending.code == 5) return;
  std::istringstream lines(ending.out);
  std::size_t complaints = 0;
  for (std::string line; std::getline(lines, line);) complaints += line.starts_with("furnas: ");
  EXPECT_EQ(complaints, 1u) << where << ending.out;
}

/// A run that was half done when the fault came, and one that had none.
class Faults : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(runs.run("whole").code, ExitCode::budget_spent);
    ASSERT_EQ(runs.run("half", {"stop.steps=130"}).code, ExitCode::budget_spent);
    ASSERT_EQ(runs.resume("half", {"--steps", "150"}).code, ExitCode::budget_spent);
  }

  /// The calls on files that a resumed, or a new, run makes.
  long calls(bool resumed) {
    const Fault none{"none", EIO, false};
    const Ending ending = attempt(resumed, 0, none);
    EXPECT_EQ(ending.code, 5) << ending.out;
    return std::stol(content(runs.path("count")));
  }

  Ending attempt(bool resumed, long at, const Fault& fault) {
    fs::remove_all(runs.path("run"));
    const auto setting = failing(runs.path("run"), at, fault, runs.path("count"));
    if (!resumed) return ending_of({"run", runs.path("case.toml"), "--out", runs.path("run")}, setting);
    fs::copy(runs.path("half"), runs.path("run"), fs::copy_options::recursive);
    return ending_of({"resume", runs.path("run"), "--steps", "240"}, setting);
  }

  /// Fails the call number `at`, then goes on without faults, to the same files.
  void try_one(bool resumed, long at, const Fault& fault) {
    const std::string where =
        std::string(resumed ? "resumed, " : "new, ") + fault.name + " at call " + std::to_string(at) + ": ";
    const Ending ending = attempt(resumed, at, fault);
    if (fault.error == 0) {
      EXPECT_EQ(ending.signal, SIGKILL) << where << ending.code << ending.out;
    } else {
      expect_plain_sentence(ending, where);
      EXPECT_EQ(Runs::unfinished(runs.path("run")), 0u) << where;
    }
    const bool saved = fs::exists(runs.path("run/a.checkpoint")) || fs::exists(runs.path("run/b.checkpoint"));
    if (!resumed && !saved) {  // nothing was saved yet, so nothing must be left
      if (fault.error != 0) {
        EXPECT_FALSE(fs::exists(runs.path("run"))) << where;
      }
      return;
    }
    const Answer again = runs.resume("run", {"--steps", "240"});
    ASSERT_EQ(again.code, ExitCode::budget_spent) << where << again.err;
    ASSERT_EQ(difference(runs.path("whole"), runs.path("run")), "") << where;
    EXPECT_EQ(Runs::unfinished(runs.path("run")), 0u) << where;
  }

  const Runs runs{small_case};
};

using ReliableFaults = Faults;
using NightlyFaults = Faults;

/// Every fifth call on a file, with a kind of fault each in turn; the others at night.
TEST_F(ReliableFaults, SomeCallsOnFilesFail) {
  const Fault kinds[] = {
      {"ENOSPC", ENOSPC, false}, {"EIO", EIO, false}, {"ENOSPC for good", ENOSPC, true}, {"kill", 0, false}};
  long tried = 0;
  for (const bool resumed : {true, false})
    for (long at = 1, last = calls(resumed); at <= last; at += 5)
      try_one(resumed, at, kinds[static_cast<std::size_t>(tried++ % 4)]);
  std::cout << "fault points tried: " << tried << '\n';
}

TEST_F(NightlyFaults, EveryCallOnAFileFails) {
  long tried = 0;
  for (const Fault& fault : {Fault{"ENOSPC", ENOSPC, false}, Fault{"EIO", EIO, false},
                             Fault{"ENOSPC for good", ENOSPC, true}, Fault{"kill", 0, false}})
    for (const bool resumed : {true, false})
      for (long at = 1, last = calls(resumed); at <= last; ++at, ++tried) try_one(resumed, at, fault);
  std::cout << "fault points tried: " << tried << '\n';
}

/// Requests for memory that are refused: a sentence and exit code 9, or a run that did not need it.
class MemoryFaults : public Faults {
 protected:
#ifdef __SANITIZE_ADDRESS__
  void SetUp() override { GTEST_SKIP() << "the sanitizer has an allocator of its own"; }
#endif
  Ending attempt_with(long at, bool lasts) {
    fs::remove_all(runs.path("run"));
    fs::copy(runs.path("half"), runs.path("run"), fs::copy_options::recursive);
    std::map<std::string, std::string> setting{{"LD_PRELOAD", FURNAS_MEMORY_FAULTS},
                                               {"FURNAS_FAULT_AFTER", ".checkpoint"},
                                               {"FURNAS_FAULT_AT", std::to_string(at)},
                                               {"FURNAS_FAULT_COUNT", runs.path("count")}};
    if (lasts) setting["FURNAS_FAULT_LASTS"] = "1";
    return ending_of({"resume", runs.path("run"), "--steps", "240"}, setting);
  }
  long requests() {
    EXPECT_EQ(attempt_with(0, false).code, 5);
    return std::stol(content(runs.path("count")));
  }
  void try_one(long at, bool lasts) {
    const std::string where = "request " + std::to_string(at) + (lasts ? " and later: " : ": ");
    const Ending ending = attempt_with(at, lasts);
    EXPECT_EQ(ending.signal, 0) << where << ending.out;
    EXPECT_TRUE(ending.code == 9 || ending.code == 5) << where << ending.code << ending.out;
    // A library that asks for memory in a destructor leaves no time to tidy up; the next process does.
    if (ending.out.find("in the middle of a file") == std::string::npos) {
      EXPECT_EQ(Runs::unfinished(runs.path("run")), 0u) << where;
    }
    ASSERT_EQ(runs.resume("run", {"--steps", "240"}).code, ExitCode::budget_spent) << where;
    ASSERT_EQ(difference(runs.path("whole"), runs.path("run")), "") << where;
  }
};

using ReliableMemoryFaults = MemoryFaults;
using NightlyMemoryFaults = MemoryFaults;

TEST_F(ReliableMemoryFaults, SomeRequestsAreRefused) {
  const long last = requests();
  long tried = 0;
  for (double at = 1; at <= static_cast<double>(last); at = at * 1.6 + 1, ++tried)
    try_one(static_cast<long>(at), tried % 2 == 1);
  std::cout << "requests refused: " << tried << " of " << last << '\n';
}

TEST_F(NightlyMemoryFaults, ManyRequestsAreRefused) {
  const long last = requests();
  const long stride = std::max(1L, last / 500);
  long tried = 0;
  for (long at = 1; at <= last; at += stride)
    for (const bool lasts : {false, true}) try_one(at, lasts), ++tried;
  std::cout << "requests refused: " << tried << " of " << last << '\n';
}

TEST_F(ReliableFaults, AFullDeviceIsTold) {
  if (!fs::exists("/dev/full")) GTEST_SKIP();
  fs::create_directory(runs.path("run"));
  fs::create_symlink("/dev/full", runs.path("run/case.resolved.toml.tmp"));
  const Answer answer = runs.run("run");
  EXPECT_EQ(answer.code, ExitCode::bad_case) << "a folder that is not empty";
  fs::remove_all(runs.path("run"));
  fs::copy(runs.path("half"), runs.path("run"), fs::copy_options::recursive);
  {
    const FullDisk full(4000);
    const Answer resumed = runs.resume("run", {"--steps", "240"});
    EXPECT_EQ(resumed.code, ExitCode::output_failed);
    EXPECT_THAT(resumed.err, HasSubstr("File too large"));
  }
  ASSERT_EQ(runs.resume("run", {"--steps", "240"}).code, ExitCode::budget_spent);
  EXPECT_EQ(difference(runs.path("whole"), runs.path("run")), "");
}

/// A process of its own meets the limit, too, and does not die of the signal that comes with it.
TEST_F(ReliableFaults, ALimitOnFilesIsNoSignal) {
  const std::string run = runs.path("run");
  fs::copy(runs.path("half"), run, fs::copy_options::recursive);
  struct rlimit before {};
  ::getrlimit(RLIMIT_FSIZE, &before);
  struct rlimit little = before;
  little.rlim_cur = 4000;
  ::setrlimit(RLIMIT_FSIZE, &little);
  Process process({"resume", run, "--steps", "240"});
  ::setrlimit(RLIMIT_FSIZE, &before);
  const Ending ending = process.wait();
  EXPECT_EQ(ending.code, 7) << ending.signal << ending.out;
  EXPECT_THAT(ending.out, HasSubstr("File too large"));
}

TEST_F(ReliableFaults, AFolderThatVanishesIsTold) {
  fs::copy(runs.path("half"), runs.path("run"), fs::copy_options::recursive);
  Process process({"resume", runs.path("run"), "--steps", "100000000"});
  while (process.runs() && fs::file_size(runs.path("run/history.csv")) < 8000)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  fs::rename(runs.path("run"), runs.path("gone"));
  const Ending ending = process.wait();
  EXPECT_EQ(ending.code, 7) << ending.out;
  EXPECT_THAT(ending.out, HasSubstr("furnas: "));
  EXPECT_THAT(ending.out, HasSubstr(runs.path("run"))) << "which file or folder depends on the moment";
  EXPECT_FALSE(fs::exists(runs.path("run"))) << "it does not come back, empty";
  ASSERT_EQ(runs.resume("gone", {"--steps", "240"}).code, ExitCode::budget_spent);
}

TEST_F(ReliableFaults, AReadOnlyFolderIsTold) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
  fs::copy(runs.path("half"), runs.path("run"), fs::copy_options::recursive);
  fs::permissions(runs.path("run"), fs::perms::owner_read | fs::perms::owner_exec);
  const Answer answer = runs.resume("run", {"--steps", "240"});
  fs::permissions(runs.path("run"), fs::perms::owner_all);
  EXPECT_EQ(answer.code, ExitCode::output_failed);
  EXPECT_THAT(answer.err, HasSubstr("Permission denied"));
}

/// The output of a program is a file like any other.
TEST_F(ReliableFaults, AFullStandardOutputIsTold) {
  if (!fs::exists("/dev/full")) GTEST_SKIP();
  const std::string command = std::string(FURNAS_PROGRAM) + " schema > /dev/full 2> " + runs.path("said");
  const int status = std::system(command.c_str());
  EXPECT_EQ(WEXITSTATUS(status), 7);
  EXPECT_THAT(content(runs.path("said")), HasSubstr("furnas: cannot write to the standard output"));
}

}  // namespace
}  // namespace furnas
