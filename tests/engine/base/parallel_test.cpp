#include "engine/base/parallel.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <atomic>
#include <cmath>
#include <stdexcept>

#include "tests/engine/support/same_packing.h"

namespace furnas {
namespace {

// More threads than the machine has, so that several really work.
class Parallel : public ::testing::TestWithParam<int> {
  tbb::global_control more_{tbb::global_control::max_allowed_parallelism, 16};
};

TEST_P(Parallel, WorkersHaveTheThreadsAskedFor) {
  const Workers workers(GetParam());
  EXPECT_EQ(workers.threads(), GetParam());
}

TEST_P(Parallel, ChunksCoverEachElementOnce) {
  Workers workers(GetParam());
  for (std::size_t count : {0, 1, 2, 63, 64, 65, 1000})
    for (std::size_t size : {1, 7, 64, 5000}) {
      std::vector<std::atomic<int>> visits(count);
      std::vector<std::atomic<int>> chunks((count + size - 1) / size);
      std::atomic<int> misplaced = 0;
      workers.run([&] {
        for_chunks(count, size, [&](std::size_t begin, std::size_t end, std::size_t chunk) {
          ++chunks[chunk];
          if (begin != chunk * size || end > count || end <= begin || end - begin > size) ++misplaced;
          for (std::size_t k = begin; k < end; ++k) ++visits[k];
        });
      });
      EXPECT_EQ(misplaced, 0);
      for (const auto& n : visits) EXPECT_EQ(n, 1);
      for (const auto& n : chunks) EXPECT_EQ(n, 1);
    }
}

TEST_P(Parallel, OrderedSumHasTheSameBits) {
  constexpr std::size_t count = 10007;
  constexpr std::size_t size = 64;
  // Terms of very different size: any other order of the sum shows.
  const auto term = [](std::size_t k) {
    const auto x = static_cast<double>(k);
    return std::sin(x) * std::pow(10.0, std::fmod(x, 20.0));
  };
  const auto body = [&](std::size_t begin, std::size_t end) {
    double part = 0;
    for (std::size_t k = begin; k < end; ++k) part += term(k);
    return part;
  };
  double expected = 0;
  for (std::size_t begin = 0; begin < count; begin += size)
    expected += body(begin, std::min(begin + size, count));

  Workers workers(GetParam());
  for (int repeat = 0; repeat < 20; ++repeat) {
    double sum = 0;
    workers.run([&] { sum = ordered_sum<double>(count, size, body); });
    EXPECT_TRUE(test::same_bits(sum, expected)) << sum << " " << expected;
  }
}

TEST_P(Parallel, ExceptionsOfTheBodyReachTheCaller) {
  Workers workers(GetParam());
  EXPECT_THROW(workers.run([] {
    for_chunks(100, 1, [](std::size_t k, std::size_t, std::size_t) {
      if (k == 57) throw std::runtime_error("57");
    });
  }),
               std::runtime_error);
}

TEST_P(Parallel, ALoopWithinALoopDoesItsWork) {
  Workers workers(GetParam());
  std::vector<std::atomic<int>> visits(400);
  workers.run([&] {
    for_chunks(20, 1, [&](std::size_t row, std::size_t, std::size_t) {
      for_chunks(20, 1, [&](std::size_t column, std::size_t, std::size_t) { ++visits[20 * row + column]; });
    });
  });
  for (const auto& n : visits) EXPECT_EQ(n, 1);
}

INSTANTIATE_TEST_SUITE_P(Threads, Parallel, ::testing::Values(1, 2, 3, 5, 8));

}  // namespace
}  // namespace furnas
