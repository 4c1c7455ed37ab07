#include "io/formats.h"

#include <algorithm>
#include <ctime>
#include <limits>

#include "io/checkpoint.h"
#include "tests/io/packings.h"

namespace furnas {
namespace {

TEST(Formats, EachThatIsWrittenAndReadRoundTrips) {
  const TemporaryFolder folder;
  const Packing p = random_packing(1);
  int count = 0;
  for (const Format& format : formats()) {
    if (!format.write || !(format.read || format.read_frame)) continue;
    ++count;
    const auto path = folder / ("packing" + std::string(extension_of(format.name)));
    write_packing(p, format.name, path);
    expect_same_packing(p, read_packing(path));
    const auto unnamed = folder / "unnamed";  // the content alone must do
    std::filesystem::rename(path, unnamed);
    expect_same_packing(p, read_packing(unnamed));
  }
  EXPECT_EQ(count, 4);
}

/// The least processor time of three writings [clock ticks].
std::clock_t time_to_write(const Format& format, std::size_t spheres, const std::filesystem::path& path) {
  Packing p = random_packing(1, spheres);
  p.labels = {};
  std::clock_t least = std::numeric_limits<std::clock_t>::max();
  for (int repeat = 0; repeat < 3; ++repeat) {
    const std::clock_t start = std::clock();
    write_packing(p, format.name, path);
    least = std::min(least, std::clock() - start);
  }
  return least;
}

TEST(Formats, EachIsWrittenInATimeThatGrowsAsTheNumberOfSpheres) {
  const TemporaryFolder folder;
  for (const Format& format : formats()) {
    if (!format.write) continue;
    EXPECT_LT(time_to_write(format, 64'000, folder / "b"), 20 * time_to_write(format, 8'000, folder / "a"))
        << format.name << ": 8 times the spheres";
  }
}

TEST(Formats, ACheckpointIsAPackingToo) {
  const TemporaryFolder folder;
  const Packing p = random_packing(2);
  write_checkpoint({p, "", {}}, folder / "a");
  expect_same_packing(p, read_packing(folder / "a"), 1e-300);
}

TEST(Formats, AFullDiskLeavesTheOldFile) {
  const TemporaryFolder folder;
  const Packing p = random_packing(3, 5000);
  for (const Format& format : formats()) {
    if (!format.write) continue;
    write_file(folder / "a", "old");
    {
      const FullDisk full(50'000);
      EXPECT_THROW(format.write(p, folder / "a"), OutputError) << format.name;
    }
    EXPECT_EQ(content(folder / "a"), "old") << format.name;
    EXPECT_EQ(folder.files(), 1u) << format.name;
  }
}

TEST(Formats, ReadsTheReferenceFiles) {
  EXPECT_EQ(read_packing(test_data("a3.data")).size(), 320u);
  EXPECT_EQ(read_packing(test_data("a3.nph.mu0.3.dump")).step, 200);
}

TEST(Formats, NamesWhatIsAllowed) {
  const TemporaryFolder folder;
  write_file(folder / "a.txt", "hello\n");
  const std::string message = input_error([&] { read_packing(folder / "a.txt"); });
  EXPECT_NE(message.find("a.txt"), std::string::npos);
  EXPECT_NE(message.find("lammps-data (.data .lmp), lammps-dump (.lammpstrj .dump), extxyz"),
            std::string::npos);
  write_file(folder / "empty.data", "");
  EXPECT_NE(input_error([&] { read_packing(folder / "empty.data"); }).find("a title line must follow"),
            std::string::npos);
  const std::string unknown = input_error([&] { write_packing(random_packing(1), "pdb", folder / "a"); });
  EXPECT_NE(unknown.find("'pdb' is no format to write; allowed are lammps-data"), std::string::npos);
  EXPECT_NE(input_error([&] { write_packing(random_packing(1), "checkpoint", folder / "a"); }), "");
}

}  // namespace
}  // namespace furnas
