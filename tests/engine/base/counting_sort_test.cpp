#include "engine/base/counting_sort.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace furnas {
namespace {

// Some keys have no number, one has a single number, and `first` held something else before.
TEST(CountingSort, GivesEachNumberAPlaceOfItsKey) {
  constexpr std::size_t count = 5000, keys = 7;
  const auto key = [](std::size_t n) { return n == 4321 ? 5 : n * n % 5; };  // 0, 1, 4, and once 5
  for (int threads : {1, 2}) {
    std::vector<std::uint32_t> first(99, 3);
    std::vector<std::size_t> sorted(count, count);
    Workers(threads).run([&] {
      counting_sort(count, keys, first, key, [&](std::size_t place, std::size_t n) { sorted[place] = n; });
    });
    ASSERT_EQ(first.size(), keys + 1);
    EXPECT_EQ(first.front(), 0u);
    EXPECT_EQ(first.back(), count);
    for (std::size_t k = 0; k < keys; ++k)
      for (std::size_t place = first[k]; place < first[k + 1]; ++place) EXPECT_EQ(key(sorted[place]), k);
    std::sort(sorted.begin(), sorted.end());
    for (std::size_t n = 0; n < count; ++n) ASSERT_EQ(sorted[n], n);
  }
}

}  // namespace
}  // namespace furnas
