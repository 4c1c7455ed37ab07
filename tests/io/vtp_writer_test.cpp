#include "io/vtp_writer.h"

#include "io/vtp_reader.h"
#include "tests/io/packings.h"

namespace furnas {
namespace {

constexpr std::size_t most_in_block = std::size_t{1} << 20;          // bytes
constexpr std::size_t block = most_in_block / sizeof(Vec3<double>);  // points

/// Points and one array of bytes, `count` of each.
PolyData bytes_at_points(std::size_t count) {
  return {
      .points = data_array("Points", count,
                           [](std::size_t k) {
                             const double x = static_cast<double>(k);
                             return Vec3<double>{x, -x, 1 / (x + 1)};
                           }),
      .points_of_a_cell = 1,
      .of_points = {data_array("byte", count, [](std::size_t k) { return static_cast<std::uint8_t>(k); })}};
}

TEST(VtpWriter, WritesWhatFillsNoBlockOrOneOrMany) {
  const TemporaryFolder folder;
  for (const std::size_t count : {std::size_t{0}, std::size_t{1}, block - 1, block, block + 1, 3 * block}) {
    write_poly_data(bytes_at_points(count), folder / "a.vtp");
    VtpReader file(folder / "a.vtp");
    ASSERT_EQ(file.points(), count);
    const std::vector<double> points = file.numbers("Points", "Points", count, 3);
    const std::vector<double> bytes = file.numbers("PointData", "byte", count, 1);
    const std::vector<double> connectivity = file.numbers("Verts", "connectivity", count, 1);
    const std::vector<double> offsets = file.numbers("Verts", "offsets", count, 1);
    for (std::size_t k = 0; k < count; ++k) {
      const double x = static_cast<double>(k);
      ASSERT_TRUE(points[3 * k] == x && points[3 * k + 1] == -x && points[3 * k + 2] == 1 / (x + 1)) << k;
      ASSERT_TRUE(bytes[k] == static_cast<double>(k % 256) && connectivity[k] == x && offsets[k] == x + 1)
          << k;
    }
  }
}

TEST(VtpWriter, AsksForABlockAtATime) {
  const TemporaryFolder folder;
  PolyData data = bytes_at_points(3 * block + 1);
  std::size_t next = 0, calls = 0;
  data.points.fill = [&](std::size_t first, std::span<char> bytes) {
    EXPECT_EQ(first, next);
    EXPECT_LE(bytes.size(), most_in_block);
    next = first + bytes.size() / sizeof(Vec3<double>);
    ++calls;
  };
  write_poly_data(data, folder / "a.vtp");
  EXPECT_EQ(next, 3 * block + 1);
  EXPECT_EQ(calls, 4U);
}

TEST(VtpWriter, NamesTypesAsVtkDoes) {
  const TemporaryFolder folder;
  PolyData data = bytes_at_points(1);
  const auto add = [&](const char* name, auto value) {
    data.field.push_back(data_array(name, 1, [value](std::size_t) { return value; }));
  };
  add("a", 0.5), add("b", std::int32_t{-3}), add("c", std::int64_t{1} << 50), add("d", std::uint8_t{200});
  add("e", std::array<std::int32_t, 3>{1, -2, 3});
  write_poly_data(data, folder / "a.vtp");
  VtpReader file(folder / "a.vtp");
  EXPECT_EQ(file.numbers("FieldData", "a", 1, 1), std::vector<double>{0.5});
  EXPECT_EQ(file.numbers("FieldData", "b", 1, 1), std::vector<double>{-3});
  EXPECT_EQ(file.numbers("FieldData", "c", 1, 1), std::vector<double>{0x1p50});
  EXPECT_EQ(file.numbers("FieldData", "d", 1, 1), std::vector<double>{200});
  EXPECT_EQ(file.numbers("FieldData", "e", 1, 3), (std::vector<double>{1, -2, 3}));
}

TEST(VtpWriter, RefusesArraysOfAnotherLength) {
  const TemporaryFolder folder;
  PolyData data = bytes_at_points(4);
  data.of_cells = data.of_points;
  write_poly_data(data, folder / "a.vtp");
  data.points_of_a_cell = 2;
  EXPECT_THROW(write_poly_data(data, folder / "a.vtp"), ContractError);
  data.of_cells.clear();
  data.of_points = bytes_at_points(3).of_points;
  EXPECT_THROW(write_poly_data(data, folder / "a.vtp"), ContractError);
}

TEST(ReliableVtpWriter, AFullDiskIsTold) {
  const TemporaryFolder folder;
  write_file(folder / "a.vtp", "old");
  for (const rlim_t room : {rlim_t{10}, rlim_t{100'000}, rlim_t{1'000'000}}) {
    const FullDisk full(room);
    try {
      write_poly_data(bytes_at_points(3 * block), folder / "a.vtp");
      ADD_FAILURE() << "written into " << room << " bytes";
    } catch (const OutputError& error) {
      EXPECT_NE(std::string(error.what()).find((folder / "a.vtp").string()), std::string::npos)
          << error.what();
    }
  }
  EXPECT_EQ(content(folder / "a.vtp"), "old");
  EXPECT_EQ(folder.files(), 1U);
}

}  // namespace
}  // namespace furnas
