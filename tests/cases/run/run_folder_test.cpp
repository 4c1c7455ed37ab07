#include "cases/program/run/run_folder.h"

#include <atomic>
#include <mutex>
#include <set>
#include <thread>

#include "tests/io/packings.h"

namespace furnas {
namespace {

namespace fs = std::filesystem;

TEST(ParseDuration, KnowsItsUnits) {
  using std::chrono::seconds;
  EXPECT_EQ(parse_duration("90s"), seconds(90));
  EXPECT_EQ(parse_duration("30m"), seconds(1800));
  EXPECT_EQ(parse_duration("2h"), seconds(7200));
  EXPECT_EQ(parse_duration("1.5h"), seconds(5400));
  EXPECT_EQ(parse_duration("1d"), seconds(86400));
  EXPECT_EQ(parse_duration("0.1s"), seconds(1));  // never cut to nothing
}

TEST(ParseDuration, RefusesWhatIsNoTime) {
  for (const char* text :
       {"", "90", "h", "-1h", "0", "0s", "2w", "2 h", "2hh", "nan", "inf", "1e99", "1e400", "two", "2h30m"}) {
    const std::string message = input_error([&] { parse_duration(text); });
    EXPECT_EQ(message.find("--walltime " + std::string(text)), 0u) << text << ": " << message;
    EXPECT_NE(message.find("allowed: a positive time with its unit, such as 90s, 30m, 2h or 1d"),
              std::string::npos);
  }
}

/// Makes a folder and keeps it, as a run does that has saved its state.
fs::path kept(const std::string& wanted, const fs::path& case_file = "a.toml") {
  RunFolder folder = RunFolder::create(wanted, case_file);
  folder.keep();
  return folder.path();
}

TEST(ReliableRunFolder, TakesANewOrEmptyOneThatIsAskedFor) {
  const TemporaryFolder folder;
  const fs::path wanted = folder / "deep/er";
  EXPECT_EQ(kept(wanted), wanted);
  EXPECT_TRUE(fs::is_directory(wanted));
  EXPECT_EQ(kept(wanted), wanted);
  EXPECT_EQ(kept(wanted.string() + "/"), wanted);
  EXPECT_TRUE(fs::is_empty(wanted));
}

TEST(ReliableRunFolder, RefusesOneThatIsTaken) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "full");
  write_file(folder / "full/result.json", "{}");
  EXPECT_NE(input_error([&] { kept(folder / "full"); }).find("already there and not empty"),
            std::string::npos);
  EXPECT_EQ(content(folder / "full/result.json"), "{}");
  write_file(folder / "file", "");
  EXPECT_NE(input_error([&] { kept(folder / "file"); }), "");
  EXPECT_NE(input_error([&] { kept(folder / "file/below"); }).find("cannot be made"), std::string::npos);
  EXPECT_EQ(folder.files(), 2u);
}

TEST(ReliableRunFolder, NumbersThoseOfACase) {
  const TemporaryFolder folder;
  const fs::path before = fs::current_path();
  fs::current_path(folder / "");
  EXPECT_EQ(kept("", "some/where/mono.toml"), "runs/mono");
  EXPECT_EQ(kept("", "mono.toml"), "runs/mono-2");
  EXPECT_EQ(kept("", "mono.toml"), "runs/mono-3");
  EXPECT_TRUE(fs::is_directory(folder / "runs/mono-3"));
  fs::current_path(before);
}

TEST(ReliableRunFolder, LeavesNothingUnlessItIsKept) {
  const TemporaryFolder folder;
  {
    const RunFolder made = RunFolder::create(folder / "a", "a.toml");
    write_file(made.path() / "x", "");
    fs::create_directories(made.path() / "frames");
  }
  EXPECT_EQ(folder.files(), 0u);
  fs::create_directory(folder / "mine");
  { write_file(RunFolder::create(folder / "mine", "a.toml").path() / "x", ""); }
  EXPECT_TRUE(fs::is_empty(folder / "mine")) << "a folder that was there stays";
}

TEST(ReliableRunFolder, IsOfOneRunAtATime) {
  const TemporaryFolder folder;
  const std::string name = folder / "a";
  {
    RunFolder first = RunFolder::create(name, "a.toml");
    first.keep();
    EXPECT_THROW(RunFolder::create(name, "a.toml"), FolderInUse);
    try {
      RunFolder::open(name);
      FAIL();
    } catch (const FolderInUse& error) {
      const std::string who = "process " + std::to_string(::getpid()) + " on ";
      EXPECT_NE(std::string(error.what()).find(who), std::string::npos) << error.what();
    }
  }
  EXPECT_TRUE(fs::is_empty(name)) << "the lock leaves no file";
  EXPECT_NO_THROW(RunFolder::open(name));
}

/// The lock of a process that was killed is no lock.
TEST(ReliableRunFolder, ADeadProcessHoldsNone) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "a");
  write_file(folder / "a/run.lock", "process 1 on nowhere\n");
  write_file(folder / "a/b.checkpoint.tmp", "half");
  EXPECT_EQ(RunFolder::open(folder / "a").path(), folder / "a");
  EXPECT_TRUE(fs::is_empty(folder / "a"));
}

/// Of many that want the same name at the same time each gets its own folder, or one gets it.
TEST(ReliableRunFolder, ARaceHasOneWinner) {
  const TemporaryFolder folder;
  const fs::path before = fs::current_path();
  fs::current_path(folder / "");
  for (int round = 0; round < 20; ++round) {
    const std::string wanted = "wanted" + std::to_string(round);
    std::atomic<int> winners{0}, losers{0};
    std::mutex mutex;
    std::vector<std::unique_ptr<RunFolder>> all;
    std::set<fs::path> names;
    {
      std::vector<std::jthread> threads;
      for (int n = 0; n < 8; ++n)
        threads.emplace_back([&] {
          auto own = std::make_unique<RunFolder>(RunFolder::create("", "mono.toml"));
          std::unique_ptr<RunFolder> same;
          try {
            same = std::make_unique<RunFolder>(RunFolder::create(wanted, "a.toml"));
            ++winners;
          } catch (const std::runtime_error&) {
            ++losers;
          }
          const std::lock_guard lock(mutex);
          names.insert(own->path());
          all.push_back(std::move(own));
          if (same) all.push_back(std::move(same));
        });
    }
    EXPECT_EQ(names.size(), 8u);
    EXPECT_EQ(winners, 1);
    EXPECT_EQ(losers, 7);
  }
  fs::current_path(before);
}

}  // namespace
}  // namespace furnas
