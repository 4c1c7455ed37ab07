#include "cases/program/sweep/turns.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>
#include <vector>

#include "tests/io/packings.h"

namespace furnas {
namespace {

using Kind = TurnRecord::Kind;
constexpr const char* one_sample = "friction=0.3~1";

/// Two workers and what each knows of the book.
class TurnBooks : public testing::Test {
 protected:
  const TemporaryFolder folder_;
  const Worker first_worker_{folder_ / "", std::chrono::seconds(60)};
  const Worker second_worker_{folder_ / "", std::chrono::seconds(60)};
  Turns first_{folder_ / "", first_worker_};
  Turns second_{folder_ / "", second_worker_};
};

TEST_F(TurnBooks, GiveATurnToOne) {
  EXPECT_EQ(first_.take(one_sample), 1);
  EXPECT_EQ(second_.take(one_sample), std::nullopt) << "it has not looked, and loses all the same";
  second_.look();
  EXPECT_EQ(second_.last(one_sample).kind, Kind::taken);
  EXPECT_EQ(second_.last(one_sample).worker, first_worker_.name());
  EXPECT_TRUE(first_.end(one_sample, 1, Kind::done, 5));
  second_.look();
  EXPECT_EQ(second_.last(one_sample).kind, Kind::done);
  EXPECT_EQ(second_.last(one_sample).number, 2);
  EXPECT_EQ(second_.last(one_sample).code, 5);
}

TEST_F(TurnBooks, NameASampleByItsWholePlaceInTheSweep) {
  EXPECT_EQ(first_.key_of(folder_ / "friction=0.3/1"), one_sample);
  EXPECT_EQ(first_.key_of(folder_ / "samples/dense/default/1"), "samples~dense~default~1");
}

TEST_F(TurnBooks, DoNotLetATurnEndThatWasTakenOver) {
  EXPECT_EQ(first_.take(one_sample), 1);
  EXPECT_FALSE(first_.lost(one_sample, 1));
  second_.look();
  EXPECT_EQ(second_.take(one_sample), 2);
  EXPECT_TRUE(first_.lost(one_sample, 1));
  EXPECT_FALSE(first_.end(one_sample, 1, Kind::done));
  EXPECT_TRUE(second_.end(one_sample, 2, Kind::done));
}

TEST_F(TurnBooks, KnowWhatIsOlderThanAWorker) {
  EXPECT_EQ(first_.take(one_sample), 1);
  EXPECT_TRUE(first_.end(one_sample, 1, Kind::done, 3));
  EXPECT_FALSE(first_.is_old(one_sample));
  const Worker later(folder_ / "", std::chrono::seconds(60));
  Turns third(folder_ / "", later);
  EXPECT_TRUE(third.is_old(one_sample));
  EXPECT_EQ(third.take(one_sample), 3);
  EXPECT_FALSE(third.is_old(one_sample));
}

TEST_F(TurnBooks, TakeARecordThatCannotBeReadForATurn) {
  write_file(folder_ / "turns/friction=0.3~1.1", "");
  first_.look();
  EXPECT_EQ(first_.last(one_sample).kind, Kind::taken);
  EXPECT_EQ(first_.last(one_sample).number, 1);
  write_file(folder_ / "turns/friction=0.3~1.1", "left somebody 0\n");
  first_.look();
  EXPECT_EQ(first_.last(one_sample).kind, Kind::left);
}

/// Eight workers want each of a hundred turns at once, and each turn has one winner.
TEST_F(TurnBooks, HaveOneWinnerOfEveryRace) {
  constexpr int workers = 8, rounds = 100;
  std::vector<std::atomic<int>> winners(rounds + 1);
  std::vector<std::thread> threads;
  for (int w = 0; w < workers; ++w)
    threads.emplace_back([&] {
      const Worker worker(folder_ / "", std::chrono::seconds(60));
      Turns turns(folder_ / "", worker);
      while (turns.last("race").number < rounds) {
        if (const auto turn = turns.take("race")) ++winners[static_cast<std::size_t>(*turn)];
        turns.look();
      }
    });
  for (std::thread& thread : threads) thread.join();
  for (int n = 1; n <= rounds; ++n) EXPECT_EQ(winners[static_cast<std::size_t>(n)], 1) << n;
}

}  // namespace
}  // namespace furnas
