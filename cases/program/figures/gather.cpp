#include "cases/program/figures/gather.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <tuple>

#include "cases/program/sweep/base_case.h"
#include "engine/base/numbers.h"
#include "engine/base/require.h"
#include "io/case_words.h"

namespace furnas {
namespace {

namespace fs = std::filesystem;
using Settings = std::map<std::string, std::string, std::less<>>;

/// A number in a unique spelling, so that equal numbers are equal texts.
std::string spelt(const std::string& value) {
  const std::optional<double> number = number_in<double>(value);
  return number ? fmt::format("{}", *number) : value;
}

/// A value in the form of a table: no quotes, blanks or commas.
std::string plain(std::string value) {
  std::erase_if(value, [](char c) { return c == '"' || c == '\'' || c == ' '; });
  std::replace(value.begin(), value.end(), ',', ';');
  return spelt(value);
}

/// A key that may differ between samples that stand together: the interval of a sample that it ended contains
/// the bound on what more steps would change.
constexpr const char* length_of_a_run = "stop.phi_error";

/// The keys that the case of a sweep sets for all its samples and that bear on phi_J.
Settings settings_of(const Case& c) {
  Settings settings;
  for (const Key& key : case_keys())
    if (bears_on_phi_J(key)) settings[key.path()] = plain(value_text(key, c));
  return settings;
}

/// Whether size_ratio and small_fraction determine the spheres, rather than a file.
bool of_two_sizes(const Case& c) { return c.start.file.empty() && c.mixture.diameters.empty(); }

/// Removes the keys that have no meaning for spheres from a file.
void forget_sizes(Settings& settings) {
  for (const char* key : {"mixture.size_ratio", fraction_key}) settings.erase(key);
}

/// All that is known of one sample.
struct Known {
  SampleRow row;
  Settings settings;
  fs::path run, sweep;
};

std::string text(double value) { return fmt::format("{}", value); }

std::vector<Known> samples_in(const fs::path& folder, bool& of_known_case) {
  const SampleTable table = read_sample_table(folder);
  const std::optional<Case> base = read_base_case(folder);
  of_known_case = base.has_value();
  const Settings common = base ? settings_of(*base) : Settings{};
  std::vector<Known> all;
  for (const SampleRow& row : table.rows) {
    Known known{row, common, folder / folder_of_sample(table.keys, row.values, row.seed), folder};
    if (std::isfinite(row.pressure)) known.settings.try_emplace("compaction.pressure", text(row.pressure));
    for (std::size_t k = 0; k < table.keys.size(); ++k) known.settings[table.keys[k]] = spelt(row.values[k]);
    if (base && !of_two_sizes(*base)) forget_sizes(known.settings);
    if (row.large > 0) known.settings[number_of_large] = text(static_cast<double>(row.large));
    all.push_back(std::move(known));
  }
  return all;
}

/// The keys that differ between samples: first those of the paper, then the others in the order of the case
/// file.
std::vector<std::string> keys_of(const std::vector<Known>& samples, const std::set<std::string>& columns) {
  std::map<std::string, std::set<std::string>> values;
  for (const Known& sample : samples)
    for (const auto& [key, value] : sample.settings) values[key].insert(value);
  std::vector<std::string> keys = keys_of_the_paper();
  for (const Key& key : case_keys()) {
    const std::string path = key.path();
    if (std::find(keys.begin(), keys.end(), path) != keys.end()) continue;
    const bool differs = path != length_of_a_run && values[path].size() > 1;
    if (columns.contains(path) || differs) keys.push_back(path);
  }
  return keys;
}

bool before(const std::string& a, const std::string& b) {
  const auto x = number_in<double>(a), y = number_in<double>(b);
  if (x && y) return *x < *y;
  return x.has_value() != y.has_value() ? x.has_value() : a < b;
}

}  // namespace

std::vector<VaryingKey> Gathered::varying() const {
  std::vector<VaryingKey> all;
  for (std::size_t k = 0; k < table.keys.size(); ++k) {
    std::set<std::string> values;
    for (const SampleRow& row : table.rows) values.insert(row.values[k]);
    if (values.size() < 2) continue;
    all.push_back({table.keys[k], {values.begin(), values.end()}});
    std::sort(all.back().values.begin(), all.back().values.end(), before);
  }
  return all;
}

Gathered gather(const std::vector<fs::path>& folders) {
  std::vector<Known> samples;
  std::set<std::string> columns;
  std::vector<std::string> without_case;
  for (const fs::path& folder : folders) {
    bool of_known_case = false;
    for (Known& known : samples_in(folder, of_known_case)) samples.push_back(std::move(known));
    for (const std::string& key : read_sample_table(folder).keys) columns.insert(key);
    if (!of_known_case) without_case.push_back(folder.string());
  }
  Gathered all;
  all.table.keys = keys_of(samples, columns);
  for (Known& sample : samples) {
    sample.row.values.clear();
    for (const std::string& key : all.table.keys) {
      const auto found = sample.settings.find(key);
      sample.row.values.push_back(found == sample.settings.end() ? "" : found->second);
    }
  }
  // A run that has settled in one folder and was carried on to rest in another is one sample.
  std::set<std::tuple<std::vector<std::string>, std::int64_t>> jammed;
  for (const Known& sample : samples)
    if (sample.row.jammed()) jammed.insert({sample.row.values, sample.row.seed});
  std::set<std::tuple<std::vector<std::string>, std::int64_t, std::string, std::string>> seen;
  for (Known& sample : samples) {
    SampleRow& row = sample.row;
    if (row.settled() && jammed.contains({row.values, row.seed})) continue;
    if (!seen.insert({row.values, row.seed, row.verdict, row.state_hash}).second) continue;
    all.table.rows.push_back(std::move(row));
    all.runs.push_back(std::move(sample.run));
    all.sweeps.push_back(std::move(sample.sweep));
  }
  if (folders.size() > 1)
    for (const std::string& folder : without_case)
      all.remarks.push_back(
          fmt::format("{} has no {} that can be read: it is assumed that its samples were made with the same "
                      "settings as the others",
                      folder, base_case_name));
  return all;
}

std::string command_for_equal_spheres(const fs::path& sweep, double friction) {
  const fs::path base = sweep / base_case_name;
  return fmt::format(
      "furnas sweep {} --samples 8 --set mixture.size_ratio=1.0 --set mixture.small_fraction=0.0 --set "
      "mixture.large=1000 --set contact.friction={} --out {}_mono_{}",
      fs::exists(base) ? base.string() : "CASE", friction, sweep.string(), friction);
}

}  // namespace furnas
