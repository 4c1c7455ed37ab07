#include "tests/cases/same_run.h"

#include <fmt/format.h>

#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "cases/program/run/recording.h"
#include "tests/engine/support/same_packing.h"
#include "tests/io/packings.h"

namespace furnas {
namespace {

namespace fs = std::filesystem;

std::set<std::string> files_of(const fs::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) names.insert(fs::relative(entry.path(), folder).string());
  return names;
}

/// The lines that begin with none of the words.
std::string without(const std::string& text, const std::vector<std::string>& words) {
  std::istringstream in(text);
  std::string kept;
  for (std::string line; std::getline(in, line);) {
    const auto begins = [&](const std::string& word) { return line.starts_with(word); };
    if (std::none_of(words.begin(), words.end(), begins)) kept += line + "\n";
  }
  return kept;
}

std::string lasting_result(const std::string& text) {
  auto json = nlohmann::ordered_json::parse(text);
  for (const char* key :
       {"wall_seconds", "cpu_seconds", "million_particle_steps_per_second", "lists_built", "threads"})
    json.erase(key);
  return json.dump(2);
}

/// A file without what may differ.
std::string lasting(const std::string& name, const std::string& text) {
  if (name == "result.json") return lasting_result(text);
  if (name == "log.txt") return without(text, {"steps ", "files "});
  if (name == "case.resolved.toml") return without(text, {"threads = "});
  if (name == "manifest.json") return {};  // lengths and hashes of all the others
  return text;
}

/// What a run would go on from, without the seconds it took and the lists it built.
std::map<std::string, std::string> lasting_memory(const Checkpoint& checkpoint) {
  auto extras = checkpoint.extras;
  std::string& counts = extras["counts: replaced lists_built wall_seconds ended"];
  counts = counts.substr(0, counts.find(' ')) + counts.substr(counts.rfind(' '));
  extras.erase("cpu seconds");
  return extras;
}

std::string difference_of_checkpoints(const fs::path& a, const fs::path& b) {
  const Checkpoint p = Checkpoints::read_newest(a), q = Checkpoints::read_newest(b);
  if (const auto same = test::same_packing(p.packing, q.packing); !same)
    return fmt::format("the packings of the checkpoints differ: {}; ", same.message());
  auto first = lasting_memory(p), second = lasting_memory(q);
  for (const auto& [key, value] : second) first.try_emplace(key);
  for (const auto& [key, value] : first)
    if (second[key] != value)
      return fmt::format("the checkpoints differ in '{}':\n{}\nand\n{}; ", key, value, second[key]);
  return {};
}

/// Where two texts part, with what follows there.
std::string parting(const std::string& a, const std::string& b) {
  const auto at = static_cast<std::size_t>(
      std::mismatch(a.begin(), a.begin() + static_cast<long>(std::min(a.size(), b.size())), b.begin()).first -
      a.begin());
  const std::size_t line = a.rfind('\n', at) == std::string::npos ? 0 : a.rfind('\n', at) + 1;
  return fmt::format("'{}' and '{}'", a.substr(line, 200), b.substr(line, 200));
}

}  // namespace

std::string difference(const fs::path& a, const fs::path& b) {
  const auto names = files_of(a);
  std::string found;
  for (const std::string& name : files_of(b))
    if (!names.contains(name)) found += name + " is only in the second; ";
  for (const std::string& name : names) {
    if (!fs::exists(b / name)) {
      found += name + " is only in the first; ";
    } else if (!name.ends_with(".checkpoint")) {
      const std::string p = lasting(name, content(a / name)), q = lasting(name, content(b / name));
      if (p != q) found += name + " differs: " + parting(p, q) + "; ";
    }
  }
  return found + difference_of_checkpoints(a, b);
}

}  // namespace furnas
