#include "io/sweep_file.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/base/require.h"
#include "io/case_file.h"
#include "io/case_schema.h"
#include "io/case_syntax.h"
#include "io/case_table.h"
#include "io/case_value.h"
#include "io/case_words.h"

namespace furnas {
namespace {

constexpr std::int64_t most_samples = 100'000;

std::string place_of(const toml::node& node, const std::string& file) {
  return fmt::format("{}:{}", file, node.source().begin.line);
}

const Key& key_of(std::string_view path, const toml::node& node, const std::string& place) {
  const std::size_t dot = path.find('.');
  const std::string_view table = path.substr(0, dot);
  const std::string_view name = dot == path.npos ? "" : path.substr(dot + 1);
  if (path == "mixture.seed")
    throw InputError(fmt::format(
        "{}: sweep.\"mixture.seed\" = {}; allowed: samples = n, which takes the seeds from mixture.seed on",
        place, node_text(node)));
  if (const Key* key = find_key(path); key != nullptr && !key->table.empty()) return *key;
  const std::string nearest = nearest_key(table, name);
  throw InputError(fmt::format(
      "{}: unknown key sweep.\"{}\" = {}; allowed: samples, and keys of the case in quotes, like \"{}\"",
      place, path, node_text(node), nearest.empty() ? "contact.friction" : nearest));
}

/// The values of one key of a grid, each checked by itself. A start.file is relative to the folder of the
/// case file.
SweepAxis axis_of(std::string_view path, const toml::node& node, const std::string& place, const Case& base,
                  const std::string& file) {
  const Key& key = key_of(path, node, place);
  SweepAxis axis{std::string(path), {}};
  const auto take = [&](const toml::node& value) {
    Case c = base;
    assign(key, value, c, place);
    if (path == start_key) c.start.file = file_path(file, path, c.start.file, place);
    if (path == "mixture.diameters") c.mixture.diameters = file_path(file, path, c.mixture.diameters, place);
    axis.values.push_back(value_text(key, c));
  };
  if (const toml::array* list = node.as_array())
    for (const toml::node& value : *list) take(value);
  else
    take(node);
  if (axis.values.empty())
    throw InputError(fmt::format("{}: sweep.\"{}\" = [] has no value; allowed: one or more", place, path));
  return axis;
}

int samples_in(const toml::node& node, const std::string& place) {
  const auto samples = node.value_exact<std::int64_t>();
  if (!samples || *samples < 1 || *samples > most_samples)
    throw InputError(fmt::format("{}: sweep.samples = {}; allowed: an integer from 1 to {}", place,
                                 node_text(node), most_samples));
  return static_cast<int>(*samples);
}

SweepGrid grid_of(const toml::table& table, const std::string& file, const Case& base) {
  SweepGrid grid{{}, 1, place_of(table, file)};
  for (const auto& [key, node] : table)
    if (key.str() == "samples")
      grid.samples = samples_in(node, place_of(node, file));
    else
      grid.axes.push_back(axis_of(key.str(), node, place_of(node, file), base, file));
  return grid;
}

/// Refuses an assignment of --set to a key that every grid sets, because it would change nothing.
void refuse_without_effect(std::string_view assignment, const SweepFile& sweep) {
  const std::string key = split_assignment(assignment).path;
  const auto gives = [&](const SweepGrid& grid) {
    return std::any_of(grid.axes.begin(), grid.axes.end(),
                       [&](const SweepAxis& axis) { return axis.key == key; });
  };
  if (std::all_of(sweep.grids.begin(), sweep.grids.end(), gives))
    throw InputError(
        fmt::format("--set {} changes nothing: [sweep] gives {} its values ({}); allowed: keys "
                    "that the sweep leaves alone",
                    assignment, key, sweep.grids.front().place));
}

}  // namespace

bool holds_sweep(const std::filesystem::path& file) { return read_table(file).contains(sweep_table); }

SweepFile sweep_of_one_point(const std::filesystem::path& file, std::span<const std::string> overrides) {
  return {read_case(file, overrides), {{{}, 1, file.string()}}};
}

SweepFile read_sweep(const std::filesystem::path& file, std::span<const std::string> overrides) {
  const toml::table root = read_table(file);
  const std::string name = file.string();
  const toml::node* node = root.get(sweep_table);
  if (node == nullptr)
    throw InputError(
        name +
        ": there is no [sweep] in it; allowed: a case with one, or --samples n, which runs it with n seeds");
  SweepFile sweep{case_in(root, file, overrides), {}};
  if (const toml::table* table = node->as_table()) sweep.grids.push_back(grid_of(*table, name, sweep.base));
  if (node->is_array_of_tables())
    for (const toml::node& table : *node->as_array())
      sweep.grids.push_back(grid_of(*table.as_table(), name, sweep.base));
  if (sweep.grids.empty())
    throw InputError(fmt::format("{}: sweep = {} is no table; allowed: [sweep], or [[sweep]] several times",
                                 place_of(*node, name), node_text(*node)));
  for (const std::string& assignment : overrides) refuse_without_effect(assignment, sweep);
  return sweep;
}

}  // namespace furnas
