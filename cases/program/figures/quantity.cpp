#include "cases/program/figures/quantity.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "cases/program/sweep/points.h"
#include "cases/program/sweep/sample_columns.h"
#include "engine/base/require.h"
#include "io/case_schema.h"

namespace furnas {
namespace {

using Json = nlohmann::json;

/// In the text of a chart, '_' makes the next letter a subscript.
std::string spaced(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

/// The value for one sample of a mean in points.csv: points_of() of a table with this sample alone.
Quantity mean_of(const PointColumn& column) {
  Quantity quantity{std::string(column.about.name), std::string(column.title), {}};
  quantity.of = [&column](const SampleRow& row, const std::filesystem::path&) -> std::optional<double> {
    const std::vector<Point> points = points_of({{}, {row}});
    const auto& mean = column.mean(points.front());
    if (!mean) return {};
    return mean->mean;
  };
  if (column.title.starts_with("share")) quantity.least = 0, quantity.most = 1;
  return quantity;
}

Quantity column_of(const SampleColumn& column) {
  return {std::string(column.about.name), std::string(column.title),
          [&column](const SampleRow& row, const std::filesystem::path&) { return number_of(column, row); }};
}

/// The number in the result.json of a run under a name with dots.
std::optional<double> field_of_result(const std::string& name, const std::filesystem::path& run) {
  const std::filesystem::path path = run / "result.json";
  std::ifstream file(path);
  if (!file)
    throw InputError(fmt::format(
        "{} cannot be read, which should hold {}; allowed: the folder of a sweep with its samples, or --y {}",
        path.string(), name, fmt::join(std::array{"phi_J", "Z", "steps"}, ", ")));
  const Json result = Json::parse(file, nullptr, false);
  const Json* here = &result;
  for (std::size_t at = 0; at <= name.size();) {
    const std::size_t dot = std::min(name.find('.', at), name.size());
    const auto found = here->is_object() ? here->find(name.substr(at, dot - at)) : here->end();
    if (!here->is_object() || found == here->end()) {
      std::vector<std::string> known;
      for (const PointColumn& column : point_columns())
        if (column.mean != nullptr) known.emplace_back(column.about.name);
      for (const SampleColumn& column : sample_columns())
        if (!column.title.empty() && std::find(known.begin(), known.end(), column.about.name) == known.end())
          known.emplace_back(column.about.name);
      throw InputError(fmt::format(
          "--y {}: neither a column nor a number in {}; allowed: {}, or the name of a number in that file",
          name, path.string(), fmt::join(known, ", ")));
    }
    here = &*found;
    at = dot + 1;
  }
  if (here->is_null()) return {};
  if (!here->is_number())
    throw InputError(
        fmt::format("--y {}: in {} this is {} and no number; allowed: the name of a number in it, "
                    "with a dot before each inner name, as cell.lx",
                    name, path.string(),
                    here->is_array()    ? "a list"
                    : here->is_object() ? "a group of fields"
                                        : "a word"));
  return here->get<double>();
}

struct KnownKey {
  std::string_view key, word, symbol, unit;  ///< `word` is the symbol in ASCII
};

constexpr KnownKey known_keys[] = {
    {"mixture.size_ratio", "alpha", "α", ""},
    {fraction_key, "f_s", "f_s", ""},
    {"contact.friction", "mu", "μ", ""},
    {"mixture.large", "N_l", "N_l", ""},
    {"compaction.pressure", "p_a", "p_a", "k_n/d_s"},
};

}  // namespace

Quantity quantity_named(const std::string& name) {
  for (const PointColumn& column : point_columns())
    if (column.mean != nullptr && column.about.name == name) return mean_of(column);
  for (const SampleColumn& column : sample_columns())
    if (column.about.name == name) {
      if (column.title.empty())
        throw InputError(fmt::format("--y {}: {}; allowed: a number", name, column.about.doc));
      return column_of(column);
    }
  return {name, spaced(name),
          [name](const SampleRow&, const std::filesystem::path& run) { return field_of_result(name, run); }};
}

std::string key_of_symbol(const std::string& symbol) {
  for (const KnownKey& known : known_keys)
    if (known.word == symbol) return std::string(known.key);
  return {};
}

std::string symbol_of_key(const std::string& key) {
  for (const KnownKey& known : known_keys)
    if (known.key == key) return std::string(known.symbol);
  return spaced(name_in(key));
}

std::string title_of_key(const std::string& key) {
  std::string unit;
  if (const Key* found = find_key(key)) unit = found->unit;
  for (const KnownKey& known : known_keys)
    if (known.key == key) unit = known.unit;
  return unit.empty() ? symbol_of_key(key) : fmt::format("{} / ({})", symbol_of_key(key), unit);
}

}  // namespace furnas
