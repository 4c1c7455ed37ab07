#include "engine/base/refill.h"

#include <gtest/gtest.h>

namespace furnas {
namespace {

TEST(Refill, KeepsTheMemoryWhereItIsEnough) {
  std::vector<int> list(100, 1);
  const int* const memory = list.data();
  refill(list, 60, 7);
  EXPECT_EQ(list, std::vector<int>(60, 7));
  refill(list, 100);
  EXPECT_EQ(list.size(), 100u);
  EXPECT_EQ(list.data(), memory);
}

// A list that grows by a hundredth at a time stays in its memory until the eighth is used up.
TEST(Refill, LeavesRoomForAnEighthMore) {
  std::vector<int> list;
  refill(list, 800, 3);
  EXPECT_EQ(list, std::vector<int>(800, 3));
  EXPECT_EQ(list.capacity(), 900u);
  const int* const memory = list.data();
  for (std::size_t count = 800; count <= 900; count += 8) refill(list, count, 4);
  EXPECT_EQ(list.data(), memory);
  refill(list, 901);
  EXPECT_EQ(list.capacity(), 1013u);
}

}  // namespace
}  // namespace furnas
