#include "io/append_file.h"

#include <gmock/gmock.h>

#include "tests/io/packings.h"

namespace furnas {
namespace {

using testing::HasSubstr;

TEST(ReliableAppendFile, GoesOnAtItsMark) {
  const TemporaryFolder folder;
  FileMark mark;
  {
    AppendFile file(folder / "a");
    EXPECT_EQ(file.mark(), (FileMark{0, Hasher().value()}));
    file.append("one\n");
    mark = file.mark();
    file.append("tw");  // a row that a crash has cut
  }
  EXPECT_EQ(mark.bytes, 4u);
  AppendFile file(folder / "a", mark);
  EXPECT_EQ(content(folder / "a"), "one\n");
  file.append("two\n");
  EXPECT_EQ(content(folder / "a"), "one\ntwo\n");
  EXPECT_EQ(file.mark().bytes, 8u);
}

TEST(ReliableAppendFile, BeginsAnew) {
  const TemporaryFolder folder;
  write_file(folder / "a", "old");
  AppendFile(folder / "a").append("new");
  EXPECT_EQ(content(folder / "a"), "new");
}

/// What precedes the mark must be what was written; else the file stays as it is.
TEST(ReliableAppendFile, RefusesWhatWasNotMarked) {
  const TemporaryFolder folder;
  FileMark mark;
  {
    AppendFile file(folder / "a");
    file.append(std::string(3'000'000, 'x'));
    mark = file.mark();
  }
  std::string changed = content(folder / "a") + "rest";
  changed[2'000'000] = 'y';
  for (const std::string& text : {changed, std::string("xxx"), std::string()}) {
    write_file(folder / "a", text);
    EXPECT_THAT(input_error([&] { AppendFile(folder / "a", mark); }), HasSubstr("its first 3000000 bytes"));
    EXPECT_EQ(content(folder / "a"), text);
  }
  EXPECT_THAT(input_error([&] { AppendFile(folder / "none", mark); }), HasSubstr("missing"));
}

/// A row that does not fit on the disk leaves no half of it.
TEST(ReliableAppendFile, AFullDiskLeavesWholeRows) {
  const TemporaryFolder folder;
  AppendFile file(folder / "a");
  file.append(std::string(90'000, 'x'));
  const FileMark before = file.mark();
  {
    const FullDisk full(100'000);
    EXPECT_THROW(file.append(std::string(50'000, 'y')), OutputError);
  }
  EXPECT_EQ(file.mark(), before);
  EXPECT_EQ(content(folder / "a").size(), 90'000u);
  file.append("z");
  EXPECT_EQ(content(folder / "a").back(), 'z');
}

TEST(ReliableAppendFile, MarksAreText) {
  const FileMark mark{123456789012, 0x0123456789abcdef};
  EXPECT_EQ(to_text(mark), "123456789012 bytes 0123456789abcdef");
  EXPECT_EQ(parse_mark(to_text(mark)), mark);
  for (const char* text : {"", "12", "12 bytes", "12 bytes xyz", "12 bytes 0123456789abcdef0", "a bytes 01",
                           "-1 bytes 01", "99999999999999999999 bytes 01"})
    EXPECT_NE(input_error([&] { parse_mark(text); }), "") << text;
}

}  // namespace
}  // namespace furnas
