#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace furnas {
namespace {

namespace fs = std::filesystem;

/// Who may include whom, besides itself. A part is a folder, or a pair of files in a room's own folder.
/// No line names a part that stands below it.
const std::vector<std::pair<std::string, std::vector<std::string>>> arrows = {
    {"engine/base", {}},
    {"engine/state", {"engine/base"}},
    {"engine/graph", {"engine/base"}},
    // A law sees a touch and its memory, never particles, cell or list.
    {"engine/laws", {"engine/base"}},
    {"engine/model", {"engine/state", "engine/laws"}},
    {"engine/search", {"engine/base", "engine/state"}},
    {"engine/kernels", {"engine/base", "engine/state", "engine/laws"}},
    {"engine/minimize", {"engine/base", "engine/state", "engine/model", "engine/search"}},
    // It judges what the others made, so it knows none of them; it asks a law for its stiffness.
    {"engine/certificate", {"engine/base", "engine/state", "engine/laws"}},
    {"engine/start", {"engine/base", "engine/state", "engine/search"}},
    // Numbers alone, never a packing.
    {"engine/statistics", {"engine/base"}},
    {"engine/analysis", {"engine/base", "engine/state", "engine/search", "engine/statistics"}},
    {"engine/monitor", {"engine/base", "engine/state", "engine/laws", "engine/model", "engine/analysis"}},
    {"engine/phases", {"engine/base", "engine/state", "engine/model", "engine/search", "engine/kernels"}},
    {"engine/step", {"engine/state", "engine/graph", "engine/model", "engine/phases"}},
    {"engine/simulation",
     {"engine/base", "engine/state", "engine/graph", "engine/model", "engine/search", "engine/monitor",
      "engine/phases", "engine/step"}},
    // A few spheres whose motion is known, for tests and benchmarks.
    {"engine/trials",
     {"engine/base", "engine/state", "engine/model", "engine/search", "engine/phases", "engine/simulation"}},
    {"engine/compaction", {"engine/base", "engine/state", "engine/monitor", "engine/simulation"}},
    // An event knows the loop that fires it; the loop knows no event.
    {"engine/events",
     {"engine/base", "engine/state", "engine/laws", "engine/search", "engine/minimize", "engine/monitor",
      "engine/compaction"}},
    // What a run is; the program adds files, console and signals.
    {"engine/protocol",
     {"engine/base", "engine/state", "engine/model", "engine/monitor", "engine/compaction", "engine/events"}},
    {"io", {"engine"}},
    {"viz", {"engine", "io"}},
    {"cases", {"engine", "io", "viz"}},
    {"tests/engine", {"engine"}},
    {"tests/fuzz", {"engine", "io"}},
    {"tests/io", {"engine", "io", "tests/engine", "tests/fuzz"}},
    {"tests/library", {"io"}},
    {"tests/viz", {"engine", "io", "viz", "tests/io"}},
    {"tests/benchmarks", {"engine", "io"}},
    {"tests/cases", {"engine", "io", "cases", "tests/engine", "tests/io"}},
    // Preloaded into the program, so they share nothing with it.
    {"tests/faults", {}},
};

/// What the engine may not touch: files, the screen, the command line and the libraries of the other rooms.
const std::regex foreign_header(
    R"(^\s*#\s*include\s*<(iostream|fstream|cstdio|stdio\.h|filesystem|print|syncstream|fmt/.*|spdlog/.*|vtk.*|toml\+\+/.*|CLI/.*|nlohmann/.*)>)");
const std::regex prints(
    R"(\bstd::(cout|cerr|clog)\b|\bfmt::print\b|\b(printf|fprintf|puts|fputs|putchar)\s*\()");
const std::regex include(R"re(^\s*#\s*include\s*"([^"]*)")re");

constexpr std::size_t most_lines = 400;

struct Source {
  std::string path;  ///< from the repository root
  std::vector<std::string> lines;
};

Source read_source(const fs::path& root, const fs::path& file) {
  Source source{fs::relative(file, root).generic_string(), {}};
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) source.lines.push_back(line);
  return source;
}

std::vector<Source> read_tree(const fs::path& root) {
  std::vector<Source> sources;
  for (const char* room : {"engine", "io", "viz", "cases", "tests"}) {
    if (!fs::exists(root / room)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(root / room)) {
      const auto extension = entry.path().extension();
      if (extension == ".h" || extension == ".cpp") sources.push_back(read_source(root, entry.path()));
    }
  }
  std::sort(sources.begin(), sources.end(), [](const auto& a, const auto& b) { return a.path < b.path; });
  return sources;
}

/// A path belongs to a part if it lies in its folder or is one of its files: part/..., part.h, part_test.cpp.
bool lies_in(const std::string& path, const std::string& part) {
  return path.starts_with(part + "/") || path.starts_with(part + ".") || path.starts_with(part + "_test.");
}

const std::pair<std::string, std::vector<std::string>>* part_of(const std::string& path) {
  for (const auto& arrow : arrows)
    if (lies_in(path, arrow.first)) return &arrow;
  return nullptr;
}

/// Every broken rule as "file:line: what".
class Violations {
 public:
  void add(const Source& source, std::size_t line, const std::string& what) {
    all_.push_back(source.path + ":" + std::to_string(line) + ": " + what);
  }

  std::string text() const {
    std::string text;
    for (const std::string& violation : all_) text += violation + "\n";
    return text;
  }

 private:
  std::vector<std::string> all_;
};

void check_includes(const Source& source, const fs::path& root, Violations& violations) {
  const auto* part = part_of(source.path);
  if (part == nullptr) return violations.add(source, 1, "its folder has no line in the table of this test");
  for (std::size_t n = 0; n < source.lines.size(); ++n) {
    std::smatch match;
    if (!std::regex_search(source.lines[n], match, include)) continue;
    const std::string included = match[1];
    if (!fs::exists(root / included))
      violations.add(source, n + 1, included + " is no path from the repository root");
    const bool allowed = lies_in(included, part->first) ||
                         std::any_of(part->second.begin(), part->second.end(),
                                     [&](const std::string& below) { return lies_in(included, below); });
    if (!allowed) violations.add(source, n + 1, part->first + " may not include " + included);
  }
}

void check_silence(const Source& source, Violations& violations) {
  if (!source.path.starts_with("engine/")) return;
  for (std::size_t n = 0; n < source.lines.size(); ++n) {
    const std::string code = source.lines[n].substr(0, source.lines[n].find("//"));
    if (std::regex_search(code, foreign_header))
      violations.add(source, n + 1, "the engine knows no files, no screen and no other room's library");
    if (std::regex_search(code, prints)) violations.add(source, n + 1, "the engine prints nothing");
  }
}

void check_shape(const Source& source, Violations& violations) {
  if (source.path.ends_with(".h") && (source.lines.empty() || source.lines.front() != "#pragma once"))
    violations.add(source, 1, "a header begins with #pragma once");
  if (source.lines.size() > most_lines)
    violations.add(source, source.lines.size(), "a file has at most 400 lines; split it by meaning");
}

/// Two types of one name make one program wrong without a word: the linker keeps one of their functions.
void check_names(const std::vector<Source>& sources, Violations& violations) {
  const std::regex definition(
      R"(^(struct|class|enum class|enum) (alignas\([^)]*\) )?(\w+)( final)?( : [^;]*)?( \{.*)?$)");
  std::map<std::string, std::string> headers;
  for (const Source& source : sources) {
    if (!source.path.ends_with(".h") || source.path.starts_with("tests/")) continue;
    for (std::size_t n = 0; n < source.lines.size(); ++n) {
      std::smatch match;
      if (!std::regex_match(source.lines[n], match, definition)) continue;
      const auto [known, is_new] = headers.emplace(match[3], source.path);
      if (!is_new) violations.add(source, n + 1, known->first + " is defined in " + known->second + ", too");
    }
  }
}

std::string violations_of(const std::vector<Source>& sources, const fs::path& root) {
  Violations violations;
  for (const Source& source : sources) {
    check_includes(source, root, violations);
    check_silence(source, violations);
    check_shape(source, violations);
  }
  check_names(sources, violations);
  return violations.text();
}

const fs::path this_tree = FURNAS_SOURCE_DIR;

TEST(Layout, HoldsInTheWholeTree) {
  const auto sources = read_tree(this_tree);
  EXPECT_GT(sources.size(), 10U);
  EXPECT_EQ(violations_of(sources, this_tree), "");
}

TEST(Layout, NothingPointsBack) {
  const auto line_of = [](const std::string& part) {
    return std::find_if(arrows.begin(), arrows.end(), [&](const auto& arrow) {
      return arrow.first == part || arrow.first.starts_with(part + "/");
    });
  };
  for (auto arrow = arrows.begin(); arrow != arrows.end(); ++arrow)
    for (const std::string& below : arrow->second)
      EXPECT_LT(line_of(below) - arrows.begin(), arrow - arrows.begin()) << arrow->first << " on " << below;
}

TEST(Layout, EachPermissionIsUsed) {
  std::set<std::string> unused;
  for (const auto& [part, others] : arrows)
    for (const std::string& other : others) unused.insert(part + " on " + other);
  for (const Source& source : read_tree(this_tree)) {
    const auto* part = part_of(source.path);
    ASSERT_NE(part, nullptr) << source.path;
    for (const std::string& line : source.lines)
      if (std::smatch match; std::regex_search(line, match, include))
        for (const std::string& other : part->second)
          if (lies_in(match[1], other)) unused.erase(part->first + " on " + other);
  }
  EXPECT_THAT(unused, testing::IsEmpty());
}

TEST(Layout, EachRuleBites) {
  const std::map<std::string, Source> broken = {
      {"engine/laws may not include engine/state/cell.h",
       {"engine/laws/a.h", {"#pragma once", "#include \"engine/state/cell.h\""}}},
      {"engine/state may not include io/case.h",
       {"engine/state/a.h", {"#pragma once", "#include \"io/case.h\""}}},
      {"io may not include cases/program/program.h", {"io/a.cpp", {"#include \"cases/program/program.h\""}}},
      {"is no path from the repository root", {"io/a.cpp", {"#include \"case.h\""}}},
      {"has no line in the table", {"engine/world/a.cpp", {""}}},
      {"the engine knows no files", {"engine/base/a.cpp", {"#include <iostream>"}}},
      {"the engine prints nothing", {"engine/base/a.cpp", {"  fmt::print(\"step\");"}}},
      {"begins with #pragma once", {"io/a.h", {"#include <vector>"}}},
      {"at most 400 lines", {"io/a.cpp", std::vector<std::string>(401)}},
  };
  for (const auto& [expected, source] : broken)
    EXPECT_NE(violations_of({source}, this_tree).find(expected), std::string::npos) << expected;
  const std::vector<Source> twins = {{"engine/base/a.h", {"#pragma once", "struct Finding {"}},
                                     {"io/a.h", {"#pragma once", "enum class Finding { yes, no };"}}};
  EXPECT_NE(violations_of(twins, this_tree).find("Finding is defined in engine/base/a.h, too"),
            std::string::npos);
}

}  // namespace
}  // namespace furnas
