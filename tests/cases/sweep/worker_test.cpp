#include "cases/program/sweep/worker.h"

#include <gtest/gtest.h>

#include "tests/io/packings.h"

namespace furnas {
namespace {

namespace fs = std::filesystem;
using std::chrono::milliseconds;
using std::chrono::seconds;

/// Another worker, as its file tells of it.
class Workers : public testing::Test {
 protected:
  Workers() { fs::create_directory(folder_ / "workers"); }
  fs::path file(const std::string& name) const { return folder_ / "workers" / name; }
  /// Its counter, its takeover time, its machine, its process and when that began.
  void write(const std::string& text) const { write_file(file("other"), text); }

  const TemporaryFolder folder_;
  const Worker own_{folder_ / "", seconds(60)};
  Watch watch_{own_};
  const Watch::Clock::time_point begin_ = Watch::Clock::now();
};

TEST_F(Workers, AreSilentWhenTheirCounterRestsForTheTakeoverTimeTheyState) {
  write("1 8.0 elsewhere 1 1\n");
  for (int second = 0; second < 8; ++second)
    EXPECT_EQ(watch_.life_of("other", begin_ + seconds(second)), Life::alive) << second;
  EXPECT_EQ(watch_.life_of("other", begin_ + seconds(8)), Life::silent);
  write("2 8.0 elsewhere 1 1\n");
  EXPECT_EQ(watch_.life_of("other", begin_ + seconds(9)), Life::alive) << "it is back";
}

TEST_F(Workers, AreNotSilentBecauseTheWatcherSlept) {
  write("1 8.0 elsewhere 1 1\n");
  EXPECT_EQ(watch_.life_of("other", begin_), Life::alive);
  for (int day = 1; day <= 3; ++day)
    EXPECT_EQ(watch_.life_of("other", begin_ + std::chrono::hours(24 * day)), Life::alive);
}

TEST_F(Workers, AreSilentWithoutAFile) {
  for (int second = 0; second < 60; ++second)
    EXPECT_EQ(watch_.life_of("nobody", begin_ + seconds(second)), Life::alive) << second;
  EXPECT_EQ(watch_.life_of("nobody", begin_ + seconds(60)), Life::silent) << "the watcher's own time";
}

TEST_F(Workers, OfThisMachineAreKnownToHaveEndedAtOnce) {
  std::string own = content(file(own_.name()));
  EXPECT_EQ(watch_.life_of(own_.name()), Life::alive);
  write(own);
  EXPECT_EQ(watch_.life_of("other"), Life::alive) << "the same process";
  own.insert(own.size() - 1, "1");  // it began at another time, so the number is that of a later process
  write(own);
  EXPECT_EQ(watch_.life_of("other"), Life::ended);
  watch_.remove_ended();
  EXPECT_FALSE(fs::exists(file("other")));
  EXPECT_TRUE(fs::exists(file(own_.name())));
}

TEST_F(Workers, BeatTwelveTimesInTheTakeoverTime) {
  const auto begin = std::chrono::steady_clock::now();
  const Worker fast(folder_ / "", milliseconds(600));
  const auto beats = [&] { return std::stoi(content(file(fast.name()))); };
  while (beats() < 25 && std::chrono::steady_clock::now() < begin + seconds(60))
    std::this_thread::sleep_for(milliseconds(5));
  EXPECT_GE(beats(), 25) << "on a machine that is busy with other work, after 60 s";
  EXPECT_GE(std::chrono::steady_clock::now() - begin, milliseconds(1200)) << "the first beat is at the begin";
}

TEST_F(Workers, LeaveNoFile) {
  std::string name;
  {
    const Worker brief(folder_ / "", seconds(1));
    name = brief.name();
    EXPECT_TRUE(fs::exists(file(name)));
  }
  EXPECT_FALSE(fs::exists(file(name)));
}

}  // namespace
}  // namespace furnas
