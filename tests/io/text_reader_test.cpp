#include "io/text_reader.h"

#include <rapidcheck.h>

#include "io/csv.h"
#include "io/text_writer.h"
#include "tests/engine/support/property.h"
#include "tests/io/packings.h"

namespace furnas {
namespace {

TEST(ReadFile, HasEveryByteOrSaysWhyNot) {
  const TemporaryFolder folder;
  std::string text("a\r\n\0b", 5);
  text.resize(100'000, 'c');  // several blocks
  write_file(folder / "a", text);
  EXPECT_EQ(read_file(folder / "a"), text);
  write_file(folder / "a", "");
  EXPECT_EQ(read_file(folder / "a"), "");
  EXPECT_NE(input_error([&] { read_file(folder / "none"); }).find("none: cannot be opened for reading"),
            std::string::npos);
  EXPECT_NE(input_error([&] { read_file((folder / "a").parent_path()); }).find("cannot be read to its end"),
            std::string::npos);
}

/// A stream whose next block does not fit into the memory.
struct NoRoom : std::streambuf {
  int_type underflow() override { throw std::bad_alloc(); }
};

TEST(ReadLine, TakesMissingMemoryForNoEnd) {
  NoRoom none;
  std::istream stream(&none);
  std::string line;
  EXPECT_THROW(read_line(stream, line), std::bad_alloc);
  std::istream table(&none);
  std::vector<std::string> cells;
  EXPECT_THROW(read_csv_row(table, cells, "table"), std::bad_alloc);
}

TEST(TextReader, GoesThroughLinesAndWords) {
  const TemporaryFolder folder;
  write_file(folder / "a", "\xEF\xBB\xBFone two\r\n\n\t three  four # five\nlast\n  ");
  TextReader reader(folder / "a");
  using Words = std::vector<std::string_view>;
  ASSERT_TRUE(reader.next_line());
  EXPECT_EQ(reader.words(), (Words{"one", "two"}));
  ASSERT_TRUE(reader.next_line());
  EXPECT_TRUE(reader.words().empty());
  ASSERT_TRUE(reader.next_line());
  EXPECT_EQ(reader.words('#'), (Words{"three", "four"}));
  EXPECT_EQ(reader.words().size(), 4u);
  ASSERT_TRUE(reader.next_line());
  EXPECT_EQ(reader.line(), "last");
  EXPECT_EQ(reader.line_number(), 4);
  ASSERT_TRUE(reader.next_line()) << "blanks at the end are harmless";
  EXPECT_FALSE(reader.next_line());
}

/// 1.25 that lost its last digit is a number, too.
TEST(TextReader, RefusesALineWithoutAnEnd) {
  const TemporaryFolder folder;
  write_file(folder / "a", "1 2\n1.2");
  TextReader reader(folder / "a");
  ASSERT_TRUE(reader.next_line());
  EXPECT_NE(input_error([&] { reader.next_line(); }).find("a:2: the file ends within this line"),
            std::string::npos);
}

TEST(TextReader, RefusesWhatIsNoNumber) {
  const TemporaryFolder folder;
  write_file(folder / "a", "x\n");
  TextReader reader(folder / "a");
  reader.next_line();
  EXPECT_EQ(reader.real("-1.5e3", "it"), -1500);
  EXPECT_EQ(reader.real("+2", "it"), 2);
  EXPECT_EQ(reader.integer("-7", "it"), -7);
  for (const char* word :
       {"", "abc", "1.5x", "nan", "inf", "-inf", "1e400", "0x10", "+-1", "1 2", "--1", "1,5"})
    EXPECT_NE(input_error([&] { reader.real(word, "it"); }).find(":1: it is '"), std::string::npos) << word;
  for (const char* word : {"", "abc", "1.5", "1e3", "9999999999999999999999", "+-1"})
    EXPECT_NE(input_error([&] { reader.integer(word, "it"); }).find(":1: it is '"), std::string::npos)
        << word;
  for (const char* word : {"0", "-1", "-0.0"}) EXPECT_THROW(reader.positive(word, "it"), InputError);
  for (const char* word : {"0", "-1", "1000000000000", "2"})
    EXPECT_THROW(reader.particle_count(word, 2), InputError) << word;
  EXPECT_EQ(reader.particle_count("1", 2), 1u);
}

TEST(TextReader, RefusesWhatIsNoFile) {
  const TemporaryFolder folder;
  EXPECT_THROW(TextReader(folder / "missing"), InputError);
  EXPECT_THROW(TextReader(folder / ""), InputError);
  EXPECT_THROW(TextReader("/dev/zero"), InputError);
}

TEST(TextWriter, NumbersReadBackBitByBit) {
  const TemporaryFolder folder;
  EXPECT_TRUE(test::holds(100, [&](double x, double y, double z) {
    {
      AtomicFile file(folder / "a");
      print(file, "{} {}\n", Vec3<double>{x, y, z}, x / 3);
      file.commit();
    }
    TextReader reader(folder / "a");
    reader.next_line();
    const auto words = reader.words();
    RC_ASSERT(words.size() == 4u);
    RC_ASSERT(reader.real(words[0], "x") == x);
    RC_ASSERT(reader.real(words[1], "y") == y);
    RC_ASSERT(reader.real(words[2], "z") == z);
    RC_ASSERT(reader.real(words[3], "x/3") == x / 3);
  }));
}

}  // namespace
}  // namespace furnas
