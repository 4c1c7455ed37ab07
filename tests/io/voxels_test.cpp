#include "io/voxels.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "engine/base/require.h"
#include "tests/io/packings.h"

namespace furnas {
namespace {

using testing::HasSubstr;

/// One sphere across all faces of a cube.
Packing corner_sphere() {
  Packing p;
  p.cell.edges = {2, 2, 2, 0, 0, 0};
  p.resize(1);
  p.radius[0] = 0.8;
  return p;
}

TEST(Voxels, AreAByteEachBesideAHeader) {
  const TemporaryFolder folder;
  const VoxelPlan plan = plan_voxels(corner_sphere(), 0.1);
  write_voxels(plan, folder / "a.mhd");
  const std::string header = content(folder / "a.mhd"), data = content(folder / "a.raw");
  EXPECT_THAT(header, HasSubstr("DimSize = 20 20 20\n"));
  EXPECT_THAT(header, HasSubstr("ElementSpacing = 0.1 0.1 0.1\n"));
  EXPECT_THAT(header, HasSubstr("ElementType = MET_UCHAR\nElementDataFile = a.raw\n"));
  ASSERT_EQ(data.size(), 8000u);
  EXPECT_EQ(plan.bytes, data.size());
  EXPECT_EQ(data[0], 1) << "the corner lies in the sphere";
  EXPECT_EQ(data[20 * 20 * 10 + 20 * 10 + 10], 0) << "the middle does not";
  const auto solid = static_cast<double>(std::count(data.begin(), data.end(), '\1'));
  EXPECT_NEAR(solid / 8000, corner_sphere().fraction_filled(), 0.01);
}

TEST(Voxels, TheHeaderHasItsOwnExtension) {
  const TemporaryFolder folder;
  EXPECT_THROW(write_voxels(plan_voxels(corner_sphere(), 0.5), folder / "a.raw"), InputError);
  EXPECT_EQ(folder.files(), 0u);
}

}  // namespace
}  // namespace furnas
