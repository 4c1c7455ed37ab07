#include "io/stl_file.h"

#include <gtest/gtest.h>

#include <cstring>

#include "tests/io/packings.h"

namespace furnas {
namespace {

TEST(StlFile, HoldsCountNormalAndCorners) {
  const TemporaryFolder folder;
  StlFile file(folder / "a.stl");
  file.add({{{0, 0, 0}, {2, 0, 0}, {0, 3, 0}}});
  file.add({{{0, 0, 0}, {2, 0, 0}, {2, 0, 0}}});  // no triangle
  file.commit();
  EXPECT_EQ(file.triangles(), 1u);
  const std::string bytes = content(folder / "a.stl");
  ASSERT_EQ(bytes.size(), StlFile::bytes_of_head + StlFile::bytes_of_triangle);
  EXPECT_FALSE(bytes.starts_with("solid")) << "would be taken for text";
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + 80, 4);
  EXPECT_EQ(count, 1u);
  float numbers[12];
  std::memcpy(numbers, bytes.data() + 84, sizeof numbers);
  const float wanted[12] = {0, 0, 1, 0, 0, 0, 2, 0, 0, 0, 3, 0};
  for (int k = 0; k < 12; ++k) EXPECT_EQ(numbers[k], wanted[k]) << k;
}

}  // namespace
}  // namespace furnas
