#include "cases/run_folder.h"

#include "tests/io/packings.h"

namespace furnas {
namespace {

namespace fs = std::filesystem;

TEST(ParseDuration, KnowsItsUnits) {
  using std::chrono::seconds;
  EXPECT_EQ(parse_duration("90"), seconds(90));
  EXPECT_EQ(parse_duration("90s"), seconds(90));
  EXPECT_EQ(parse_duration("30m"), seconds(1800));
  EXPECT_EQ(parse_duration("2h"), seconds(7200));
  EXPECT_EQ(parse_duration("1.5h"), seconds(5400));
  EXPECT_EQ(parse_duration("1d"), seconds(86400));
  EXPECT_EQ(parse_duration("0.1s"), seconds(1));  // never cut to nothing
}

TEST(ParseDuration, RefusesWhatIsNoTime) {
  for (const char* text :
       {"", "h", "-1h", "0", "0s", "2w", "2 h", "2hh", "nan", "inf", "1e99", "1e400", "two", "2h30m"}) {
    const std::string message = input_error([&] { parse_duration(text); });
    EXPECT_EQ(message.find("--walltime " + std::string(text)), 0u) << text << ": " << message;
    EXPECT_NE(message.find("allowed: a positive time such as 90s, 30m, 2h or 1d"), std::string::npos);
  }
}

TEST(RunFolder, TakesANewOrEmptyOneThatIsAskedFor) {
  const TemporaryFolder folder;
  const fs::path wanted = folder / "deep/er";
  EXPECT_EQ(create_run_folder(wanted, "a.toml"), wanted);
  EXPECT_TRUE(fs::is_directory(wanted));
  EXPECT_EQ(create_run_folder(wanted, "a.toml"), wanted);
}

TEST(RunFolder, RefusesOneThatIsTaken) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "full");
  write_file(folder / "full/result.json", "{}");
  EXPECT_NE(
      input_error([&] { create_run_folder(folder / "full", "a.toml"); }).find("already there and not empty"),
      std::string::npos);
  EXPECT_EQ(content(folder / "full/result.json"), "{}");
  write_file(folder / "file", "");
  EXPECT_NE(input_error([&] { create_run_folder(folder / "file", "a.toml"); }), "");
  EXPECT_NE(
      input_error([&] { create_run_folder(folder / "file/below", "a.toml"); }).find("cannot make the folder"),
      std::string::npos);
}

TEST(RunFolder, NumbersThoseOfACase) {
  const TemporaryFolder folder;
  const fs::path before = fs::current_path();
  fs::current_path(folder / "");
  EXPECT_EQ(create_run_folder("", "some/where/mono.toml"), "runs/mono");
  EXPECT_EQ(create_run_folder("", "mono.toml"), "runs/mono-2");
  EXPECT_EQ(create_run_folder("", "mono.toml"), "runs/mono-3");
  EXPECT_TRUE(fs::is_directory(folder / "runs/mono-3"));
  fs::current_path(before);
}

}  // namespace
}  // namespace furnas
