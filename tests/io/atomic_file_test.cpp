#include "io/atomic_file.h"

#include "tests/io/packings.h"

namespace furnas {
namespace {

TEST(ReliableAtomicFile, AppearsCompleteUnderItsName) {
  const TemporaryFolder folder;
  const std::string text(3'000'000, 'a');  // more than the buffer
  {
    AtomicFile file(folder / "a.txt");
    file.write("b");
    file.write(text);
    EXPECT_FALSE(std::filesystem::exists(folder / "a.txt"));
    file.commit();
  }
  EXPECT_EQ(content(folder / "a.txt"), "b" + text);
  EXPECT_EQ(folder.files(), 1u);
}

/// In the buffer, on the disk, and across the border of both.
TEST(ReliableAtomicFile, OverwritesWhatWasWritten) {
  const TemporaryFolder folder;
  const std::size_t flushed = 1'500'000;  // more than the buffer
  std::string expected = std::string(flushed, 'a') + "bcdef";
  AtomicFile file(folder / "a.txt");
  file.write(expected.substr(0, flushed));
  file.write("bcdef");
  ASSERT_EQ(file.size(), expected.size());
  for (const std::size_t at : {flushed + 3, std::size_t{0}, flushed - 1, flushed / 2}) {
    file.overwrite(at, "12");
    expected.replace(at, 2, "12");
  }
  file.write("g");
  EXPECT_THROW(file.overwrite(expected.size(), "12"), ContractError);
  file.commit();
  EXPECT_EQ(content(folder / "a.txt"), expected + "g");
}

TEST(ReliableAtomicFile, LeavesTheOldFileUnlessCommitted) {
  const TemporaryFolder folder;
  write_file(folder / "a.txt", "old");
  { AtomicFile(folder / "a.txt").write("new"); }
  EXPECT_EQ(content(folder / "a.txt"), "old");
  EXPECT_EQ(folder.files(), 1u);
  write_file(folder / "a.txt", "new");
  EXPECT_EQ(content(folder / "a.txt"), "new");
}

TEST(ReliableAtomicFile, NamesWhatCannotBeWritten) {
  const TemporaryFolder folder;
  EXPECT_THROW(write_file(folder / "no/such/folder/a.txt", "a"), OutputError);
  std::filesystem::create_directory(folder / "b.txt");
  EXPECT_THROW(write_file(folder / "b.txt", "a"), OutputError);
  EXPECT_EQ(folder.files(), 1u);
}

TEST(ReliableAtomicFile, KeepsTheOldFileWhenTheDiskIsFull) {
  const TemporaryFolder folder;
  write_file(folder / "a.txt", "old");
  {
    const FullDisk full(100'000);
    EXPECT_THROW(write_file(folder / "a.txt", std::string(200'000, 'a')), OutputError);
  }
  EXPECT_EQ(content(folder / "a.txt"), "old");
  EXPECT_EQ(folder.files(), 1u);
}

}  // namespace
}  // namespace furnas
