#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <type_traits>
#include <vector>

#include "engine/base/parallel.h"
#include "engine/base/require.h"
#include "engine/search/grid.h"
#include "engine/simulation.h"
#include "engine/start/mixture.h"
#include "engine/state/pair_list.h"

namespace furnas {
namespace {

constexpr std::size_t beyond = std::size_t{1} << 32;  // the first number that 32 bits do not hold

// A hundred rows for each of 3e7 spheres, the most of the job; find_pairs refuses more rows than that.
static_assert(std::numeric_limits<RowNumber>::max() > 100 * 30'000'000LL);
static_assert(std::is_same_v<decltype(std::declval<PairList>().rows()), std::size_t>);
static_assert(std::is_same_v<decltype(std::declval<Packing>().size()), std::size_t>);

TEST(LargeCounts, LoopsCoverThem) {
  std::vector<std::size_t> begins;
  std::vector<std::size_t> ends;
  Workers(1).run([&] {
    for_chunks(3 * beyond + 5, beyond, [&](std::size_t begin, std::size_t end, std::size_t piece) {
      EXPECT_EQ(piece, begins.size());
      begins.push_back(begin);
      ends.push_back(end);
    });
  });
  EXPECT_EQ(begins, (std::vector<std::size_t>{0, beyond, 2 * beyond, 3 * beyond}));
  EXPECT_EQ(ends, (std::vector<std::size_t>{beyond, 2 * beyond, 3 * beyond, 3 * beyond + 5}));
  const auto count = [](std::size_t begin, std::size_t end) { return static_cast<double>(end - begin); };
  EXPECT_EQ(ordered_sum<double>(3 * beyond + 5, beyond / 4, count), 3.0 * static_cast<double>(beyond) + 5);
}

TEST(LargeCounts, BinsOfTheFinestGridAreTold) {
  Grid grid;
  grid.count = {1 << 20, 1 << 20, 1 << 20};
  const std::int64_t last = grid.coordinate(0, 1.0);
  EXPECT_EQ(last, (1 << 20) - 1);
  EXPECT_EQ(grid.bin(last, 0, 0) + 1, grid.bin(0, 1, 0));
  EXPECT_EQ(grid.bin(last, last, 0) + 1, grid.bin(0, 0, 1));
  EXPECT_EQ(grid.bin(last, last, last), (std::size_t{1} << 60) - 1);
}

TEST(LargeCounts, OfAMixtureAreExact) {
  EXPECT_EQ(small_count({.size_ratio = 40, .small_fraction = 0.292, .large = 1000}), 26'395'480);
  EXPECT_EQ(small_count({.size_ratio = 100, .small_fraction = 0.5, .large = 5000}), 5'000'000'000);
  EXPECT_EQ(small_count({.size_ratio = 100, .small_fraction = 0.75, .large = 10'000'000}),
            30'000'000'000'000);
}

TEST(LargeCounts, BeyondTheNumbersOfSpheresAreRefusedBeforeTheyAreMade) {
  try {
    dilute_start({.size_ratio = 100, .small_fraction = 0.5, .large = 5000});
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("5000005000 spheres are wanted; at most 2147483647"));
  }
}

TEST(LargeCounts, GetAllThreads) {
  for (std::size_t particles : {beyond, 3000 * beyond, std::numeric_limits<std::size_t>::max()})
    EXPECT_EQ(threads_for(particles), available_threads());
  EXPECT_EQ(threads_for(1), 1);
}

}  // namespace
}  // namespace furnas
