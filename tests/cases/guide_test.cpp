#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "io/case_schema.h"
#include "tests/cases/process.h"
#include "tests/io/packings.h"

namespace furnas {
namespace {

namespace fs = std::filesystem;

const fs::path checkout_root = FURNAS_SOURCE_DIR;

/// The pages whose commands are run, in the order in which a new user reads them.
const std::vector<std::string> guide_pages{"README.md",
                                           "docs/guide/first-steps.md",
                                           "docs/guide/case-files.md",
                                           "docs/guide/units.md",
                                           "docs/guide/end-of-a-run.md",
                                           "docs/guide/stopping-and-resuming.md",
                                           "docs/guide/analysis.md",
                                           "docs/guide/pictures.md",
                                           "docs/guide/sweeps.md",
                                           "docs/guide/how-sure.md",
                                           "docs/guide/other-programs.md"};

/// A line of a block ```sh, and what its comment says.
struct ShownCommand {
  std::string text;
  double seconds{};  ///< how long it takes; 0 without a word about it
  int code{};        ///< with which it ends
};

/// What a page shows: commands, and files, which are blocks with the name of the file as a comment on top.
struct ShownPage {
  std::vector<ShownCommand> commands;
  std::map<std::string, std::string> files;
};

ShownCommand command_of(const std::string& line) {
  static const std::regex comment(R"(\s+#.*$)"), time(R"(#.*?\b(\d+) (s|min|hours?)\b)"),
      code(R"(exit code (\d+))");
  ShownCommand shown{std::regex_replace(line, comment, ""), 0, 0};
  std::smatch found;
  const bool timed = std::regex_search(line, found, time);
  static const std::regex vague(R"(#.*\b(minutes|hours?|days?)\b)");
  EXPECT_TRUE(timed || !std::regex_search(line, vague))
      << line << "\na time needs a number: # 20 s, # 3 min, # 9 hours";
  if (timed) shown.seconds = std::stod(found[1]) * (found[2] == "s" ? 1 : found[2] == "min" ? 60 : 3600);
  if (std::regex_search(line, found, code)) shown.code = std::stoi(found[1]);
  return shown;
}

ShownPage shown_on(const std::string& page) {
  static const std::regex name(R"(# ([\w-]+\.[\w]+))");
  ShownPage shown;
  std::istringstream text(content(checkout_root / page));
  std::string* file = nullptr;
  bool inside = false, shell = false, first = false;
  for (std::string line; std::getline(text, line);) {
    if (line.starts_with("```")) {
      inside = !inside, first = true, file = nullptr, shell = line == "```sh";
      continue;
    }
    if (!inside) continue;
    std::smatch match;
    if (first && std::regex_match(line, match, name)) file = &shown.files[match[1]];
    first = false;
    if (file != nullptr) *file += line + "\n";
    if (shell && !line.empty() && !line.starts_with("#")) shown.commands.push_back(command_of(line));
  }
  return shown;
}

/// A folder as a checkout looks to a reader: ./furnas, cases/ and docs/.
class Desk {
 public:
  Desk() {
    std::string pattern = (fs::temp_directory_path() / "furnas_guide_XXXXXX").string();
    folder_ = ::mkdtemp(pattern.data());
    for (const char* name : {"cases", "docs"})
      fs::create_directory_symlink(checkout_root / name, folder_ / name);
    fs::create_symlink(FURNAS_PROGRAM, folder_ / "furnas");
  }
  ~Desk() { fs::remove_all(folder_); }
  Desk(const Desk&) = delete;
  Desk& operator=(const Desk&) = delete;

  void put(const std::map<std::string, std::string>& files) const {
    for (const auto& [name, text] : files) std::ofstream(folder_ / name) << text;
  }

  Ending type(const std::string& command) const {
    Ending ending;
    std::FILE* pipe = ::popen(("cd '" + folder_.string() + "' && exec 2>&1; " + command).c_str(), "r");
    for (int letter = std::fgetc(pipe); letter != EOF; letter = std::fgetc(pipe))
      ending.out += static_cast<char>(letter);
    const int status = ::pclose(pipe);
    ending.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    return ending;
  }

  void expect(const std::string& page, const ShownCommand& shown) const {
    const std::string program = shown.text.substr(0, shown.text.find(' '));
    if (program != "./furnas" && type("command -v " + program).code != 0) return;  // LAMMPS is not everywhere
    const Ending ending = type(shown.text);
    EXPECT_EQ(ending.code, shown.code) << page << ": " << shown.text << "\n" << ending.out;
  }

 private:
  fs::path folder_;
};

/// The script at the root, which FrontDoor tests, and not the program.
bool is_for_the_script(const ShownCommand& shown) { return shown.text.starts_with("./furnas test"); }

class Guide : public testing::TestWithParam<std::string> {};

/// The folder that a command names for a run; empty for other commands.
std::string folder_made_by(const std::string& command) {
  static const std::regex run(R"(\./furnas run .*--out (\S+).*)");
  std::smatch match;
  return std::regex_match(command, match, run) ? match[1].str() : "";
}

/// Commands without a time on the page run as they stand; small runs stand in for the others.
TEST_P(Guide, ShortCommandsRun) {
  const ShownPage page = shown_on(GetParam());
  const Desk desk;
  desk.put(page.files);
  const auto make_run = [&](const std::string& folder) {
    desk.expect(GetParam(),
                {.text = "./furnas run cases/smoke.toml --set output.picture=none --out " + folder});
  };
  make_run("runs/first_packing");
  for (const ShownCommand& shown : page.commands) {
    const std::string folder = folder_made_by(shown.text);
    if (shown.seconds == 0 && !is_for_the_script(shown)) desk.expect(GetParam(), shown);
    if (shown.seconds > 0 && !folder.empty() && folder != "runs/first_packing") make_run(folder);
  }
}

INSTANTIATE_TEST_SUITE_P(Pages, Guide, testing::ValuesIn(guide_pages), [](const auto& page) {
  std::string name = fs::path(page.param).stem().string();
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return name;
});

/// All commands, in the order of the pages, but for those that take an hour and more.
TEST(NightlyGuide, EveryCommandRuns) {
  const Desk desk;
  std::size_t run = 0;
  for (const std::string& name : guide_pages) {
    const ShownPage page = shown_on(name);
    desk.put(page.files);
    for (const ShownCommand& shown : page.commands)
      if (shown.seconds < 3600 && !is_for_the_script(shown)) desk.expect(name, shown), ++run;
  }
  EXPECT_GT(run, 30u);
}

/// The lines of every page that have a word; searching all of them by a regular expression would take
/// seconds.
std::vector<std::string> lines_with(const std::string& word) {
  std::vector<fs::path> pages{checkout_root / "README.md", checkout_root / "CONTRIBUTING.md"};
  for (const auto& entry : fs::recursive_directory_iterator(checkout_root / "docs"))
    if (entry.path().extension() == ".md") pages.push_back(entry.path());
  std::vector<std::string> lines;
  for (const fs::path& page : pages) {
    std::istringstream text(content(page));
    for (std::string line; std::getline(text, line);)
      if (line.find(word) != line.npos) lines.push_back(line);
  }
  return lines;
}

/// Calls visit(match) for each place in some lines where a pattern is found; how many there are.
template <class Visit>
int visit_matches(const std::vector<std::string>& lines, const std::string& pattern, Visit&& visit) {
  const std::regex expression(pattern);
  int found = 0;
  for (const std::string& line : lines)
    for (std::sregex_iterator at(line.begin(), line.end(), expression), end; at != end; ++at, ++found)
      visit(*at);
  return found;
}

TEST(Documents, ShowOptionsThatExist) {
  std::map<std::string, std::string> help;
  int options = 0;
  visit_matches(lines_with("furnas "), R"((?:^|`| )(?:\./)?furnas ((?:bench )?[a-z]+)([^`#|&]*))",
                [&](const auto& call) {
                  const std::string command = call[1], rest = call[2];
                  if (rest.find("--") == rest.npos) return;
                  if (!help.contains(command)) {
                    std::vector<std::string> words;
                    std::istringstream in(command);
                    for (std::string word; in >> word;) words.push_back(word);
                    words.push_back("--help");
                    const Ending ending = ending_of(words);
                    EXPECT_EQ(ending.code, 0) << command;
                    help[command] = ending.out;
                  }
                  options += visit_matches({rest}, "--[a-z][a-z-]*", [&](const auto& option) {
                    EXPECT_TRUE(help[command].find(option.str()) != std::string::npos)
                        << command << " has no " << option.str();
                  });
                });
  EXPECT_GT(options, 30);
}

TEST(Documents, NameCasesAndKeysThatExist) {
  std::set<std::string> keys, tables;
  for (const Key& k : case_keys()) {
    keys.insert(std::string(k.table) + "." + std::string(k.name));
    if (!k.table.empty()) tables.insert(std::string(k.table));
  }
  int found = visit_matches(lines_with("cases/"), R"(\bcases/[\w/]+\.toml)", [](const auto& match) {
    EXPECT_TRUE(fs::exists(checkout_root / match.str())) << match.str();
  });
  for (const std::string& table : tables)
    found += visit_matches(lines_with(table + "."), "(?:`|--set )(" + table + R"(\.[a-z_]+)\b)",
                           [&](const auto& match) { EXPECT_TRUE(keys.contains(match[1])) << match.str(); });
  EXPECT_GT(found, 50);
}

/// docs/reference/commands.md has a row for each command, and no other.
TEST(Documents, ListEveryCommand) {
  const auto names = [](const std::string& text, const std::string& pattern) {
    std::set<std::string> all;
    const std::regex row(pattern);
    for (std::sregex_iterator at(text.begin(), text.end(), row), end; at != end; ++at) all.insert((*at)[1]);
    return all;
  };
  const std::string help = ending_of({"--help"}).out;
  const std::size_t from = help.find("Commands:"), to = help.find("furnas COMMAND");
  ASSERT_NE(to, help.npos);
  const auto offered = names(help.substr(from, to - from), R"(\n  ([a-z]+) )");
  EXPECT_GT(offered.size(), 10u);
  EXPECT_EQ(names(content(checkout_root / "docs/reference/commands.md"), R"(\n\| `([a-z]+)[ `])"), offered);
}

}  // namespace
}  // namespace furnas
