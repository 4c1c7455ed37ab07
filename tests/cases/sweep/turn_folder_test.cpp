#include "cases/program/sweep/turn_folder.h"

#include <gtest/gtest.h>

#include <fstream>

#include "io/checkpoint.h"
#include "tests/io/packings.h"

namespace furnas {
namespace {

namespace fs = std::filesystem;

class TurnFolders : public testing::Test {
 protected:
  TurnFolders() {
    sample_.folder = folder_ / "samples/point/1";
    fs::create_directories(sample_.folder.parent_path());
  }
  TurnFolder turn(int number) const { return {sample_, number}; }
  /// What a run that came to `step` leaves in a folder.
  static void leave_run(const fs::path& run, std::int64_t step) {
    fs::create_directories(run / "frames");
    Packing packing = random_packing(1);
    packing.step = step;
    write_checkpoint({packing, "", {}}, run / "a.checkpoint");
    write_file(run / "history.csv", std::to_string(step));
    write_file(run / "frames/frame.vtp", std::to_string(step));
    write_file(run / "b.checkpoint.tmp", "unfinished");
  }
  std::string history(const fs::path& run) const { return content(run / "history.csv"); }

  const TemporaryFolder folder_;
  Sample sample_;
};

TEST_F(TurnFolders, BeginWithTheNewestThatWasSaved) {
  leave_run(sample_.folder, 100);
  leave_run(turn(1).run(), 300);
  leave_run(turn(3).run(), 200);
  turn(5).make();
  turn(5).fill();
  EXPECT_EQ(history(turn(5).run()), "300");
  EXPECT_EQ(content(turn(5).run() / "frames/frame.vtp"), "300");
  EXPECT_FALSE(fs::exists(turn(5).run() / "b.checkpoint.tmp"));
  EXPECT_EQ(history(turn(1).run()), "300") << "it stays where it is";
}

TEST_F(TurnFolders, BeginEmptyWhereNothingWasSaved) {
  turn(1).make();
  turn(1).fill();
  EXPECT_TRUE(turn(1).exists());
  EXPECT_FALSE(fs::exists(turn(1).run()));
}

TEST_F(TurnFolders, TellTheStepOfTheLastProgressLine) {
  turn(1).make();
  EXPECT_FALSE(turn(1).last_step()) << "no log";
  std::string log = "Mps: million particle-steps a second\n";
  write_file(turn(1).log(), log);
  EXPECT_FALSE(turn(1).last_step());
  for (int step = 1000; step <= 50'000; step += 1000)
    log += "step " + std::to_string(step) + "  phi 0.5  12 Mps   stress 2.0e-02 falls, needs 1e-03\n";
  write_file(turn(1).log(), log);
  EXPECT_EQ(turn(1).last_step(), 50'000) << "of a log longer than what is read of it";
  write_file(turn(1).log(), log + "steps     50123 in 4 s\n");
  EXPECT_EQ(turn(1).last_step(), 50'000) << "the lines of the verdict are no progress lines";
}

TEST_F(TurnFolders, DoNotSeeWhatALateWriterAdds) {
  leave_run(turn(1).run(), 300);
  std::ofstream late(turn(1).run() / "history.csv", std::ios::app);
  turn(2).make();
  turn(2).fill();
  late << " and more" << std::flush;
  EXPECT_EQ(history(turn(1).run()), "300 and more");
  EXPECT_EQ(history(turn(2).run()), "300");
}

TEST_F(TurnFolders, PutTheirRunInItsPlaceAndRemoveEarlierOnes) {
  leave_run(sample_.folder, 100);
  leave_run(turn(1).run(), 200);
  leave_run(turn(2).run(), 300);
  write_file(turn(2).log(), "said");
  turn(2).publish();
  EXPECT_EQ(history(sample_.folder), "300");
  EXPECT_EQ(content(sample_.folder / "frames/frame.vtp"), "300");
  EXPECT_EQ(content(sample_.log()), "said");
  EXPECT_FALSE(turn(1).exists());
  EXPECT_FALSE(turn(2).exists());
  turn(2).publish();
  EXPECT_EQ(history(sample_.folder), "300") << "once more changes nothing";
}

/// A worker that ends its turn late, when another has put it and a later one in their places.
TEST_F(TurnFolders, OfALateWorkerHarmNoLaterOne) {
  leave_run(turn(1).run(), 100);
  turn(1).publish();
  leave_run(turn(3).run(), 300);
  turn(3).publish();
  turn(1).publish();
  EXPECT_EQ(history(sample_.folder), "300");
}

TEST_F(TurnFolders, OfARunThatLeftNothingLeaveItsLog) {
  turn(1).make();
  write_file(turn(1).log(), "furnas: refused");
  turn(1).publish();
  EXPECT_EQ(content(sample_.log()), "furnas: refused");
  EXPECT_FALSE(fs::exists(sample_.folder));
  EXPECT_FALSE(turn(1).exists());
}

}  // namespace
}  // namespace furnas
