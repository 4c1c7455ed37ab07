#include "io/case_file.h"

#include <fmt/format.h>

#include <array>
#include <map>

#include "engine/base/require.h"
#include "io/case_check.h"
#include "io/case_preset.h"
#include "io/case_schema.h"
#include "io/case_syntax.h"
#include "io/case_table.h"
#include "io/case_value.h"
#include "io/case_words.h"
#include "io/text_reader.h"

namespace furnas {
namespace {

/// Where each key was given, by its path: "case.toml:3" or "--set".
using KeyPlaces = std::map<std::string, std::string>;

constexpr const char* override_place = "--set";
constexpr const char* preset_key = "preset";

std::string hint(const std::string& nearest, const std::string& known) {
  if (!nearest.empty()) return fmt::format("the nearest known one is {}", nearest);
  return fmt::format("known are {}", known);
}

std::string known_keys(std::string_view table) {
  std::string names;
  for (const Key& key : case_keys())
    if (key.table == table) names += fmt::format("{}{}", names.empty() ? "" : ", ", key.name);
  return names;
}

std::string known_tables() {
  std::string names;
  for (const std::string_view table : case_tables())
    names += fmt::format("{}[{}]", names.empty() ? "" : ", ", table);
  return names;
}

[[noreturn]] void refuse_unknown_key(std::string_view table, std::string_view name, const toml::node& node,
                                     const std::string& place) {
  throw InputError(fmt::format("{}: unknown key {}.{} = {}; {}", place, table, name, node_text(node),
                               hint(nearest_key(table, name), known_keys(table))));
}

[[noreturn]] void refuse_unknown_table(std::string_view table, const toml::node& node,
                                       const std::string& place) {
  if (!node.is_table() && !node.is_array_of_tables()) {
    const std::string nearest = nearest_key("", table);
    throw InputError(fmt::format("{}: unknown key {} = {} outside of a table; {}", place, table,
                                 node_text(node), hint(nearest, known_tables())));
  }
  const std::string nearest = nearest_table(table);
  throw InputError(fmt::format("{}: unknown table [{}]; {}", place, table,
                               hint(nearest.empty() ? nearest : "[" + nearest + "]", known_tables())));
}

bool is_table_name(std::string_view name) {
  for (const std::string_view table : case_tables())
    if (table == name) return true;
  return false;
}

/// Refuses two keys that set the same quantity in different units.
void refuse_rivals(const KeyPlaces& places) {
  for (const Key& key : case_keys()) {
    const std::string rival = fmt::format("{}.{}", key.table, key.rival);
    if (!key.rival.empty() && places.contains(key.path()) && places.contains(rival))
      throw InputError(
          fmt::format("{}: {} and {} set the same quantity in different units; allowed: one of them",
                      places.at(key.path()), key.path(), rival));
  }
}

/// Sets the preset that was given last, by an override or in the file.
void set_preset(Case& c, const toml::table& root, const std::string& name,
                std::span<const std::string> overrides, KeyPlaces& places) {
  if (const toml::node* node = root.get(preset_key)) {
    const std::string place = fmt::format("{}:{}", name, node->source().begin.line);
    assign(*find_key("", preset_key), *node, c, place);
    places[preset_key] = place;
  }
  for (const std::string& assignment : overrides)
    if (split_assignment(assignment).path == preset_key) apply_override(c, assignment);
  for (const std::string_view assignment : assignments_of(c.preset)) apply_override(c, assignment);
}

/// Sets the keys of a parsed file, each checked by itself, in a case that holds the values of its preset.
void read_keys(const toml::table& root, const std::string& name, Case& c, KeyPlaces& places) {
  const auto place_of = [&](const toml::node& node) {
    return fmt::format("{}:{}", name, node.source().begin.line);
  };
  for (const auto& [table_name, node] : root) {
    if (table_name.str() == sweep_table || table_name.str() == preset_key) continue;
    const toml::table* table = node.as_table();
    if (!is_table_name(table_name.str())) refuse_unknown_table(table_name.str(), node, place_of(node));
    if (table == nullptr)
      throw InputError(fmt::format("{}: {} = {} is not a table; allowed: [{}] once, keys below it",
                                   place_of(node), table_name.str(), node_text(node), table_name.str()));
    for (const auto& [key_name, value] : *table) {
      const std::string place = place_of(value);
      const Key* key = find_key(table_name.str(), key_name.str());
      if (key == nullptr) refuse_unknown_key(table_name.str(), key_name.str(), value, place);
      assign(*key, value, c, place);
      places[key->path()] = place;
    }
  }
  refuse_rivals(places);
  if (!c.start.file.empty() && root.contains("mixture"))
    throw InputError(
        fmt::format("{}: start.file = \"{}\" and [mixture] exclude each other; allowed: one of them",
                    places.at("start.file"), c.start.file));
}

/// toml++ reads numbers from streams. A stream that gets no memory does not report this but calls the number
/// wrong; therefore a text that seems wrong is parsed a second time. toml++ does not get the name of the
/// file, because it would copy the name in a function that must not throw.
toml::table parse_toml(std::string_view text) {
  try {
    return toml::parse(text);
  } catch (const toml::parse_error&) {
    return toml::parse(text);
  }
}

toml::table parse_text(std::string_view text, const std::string& name) {
  try {
    return parse_toml(text);
  } catch (const toml::parse_error& error) {
    throw InputError(explain_syntax(text, name, error.source().begin.line, error.description()));
  }
}

void refuse_many_cases(const toml::table& root, const std::string& name) {
  if (const toml::node* sweep = root.get(sweep_table))
    throw InputError(fmt::format("{}:{}: [sweep] makes this file many cases; allowed: furnas sweep or check",
                                 name, sweep->source().begin.line));
  if (const toml::node* arms = root.get(tradeoff_table))
    throw InputError(fmt::format("{}:{}: [{}] makes this file many cases; allowed: furnas bench tradeoff",
                                 name, arms->source().begin.line, tradeoff_table));
}

void apply_overrides(Case& c, std::span<const std::string> overrides, KeyPlaces& places) {
  for (const std::string& assignment : overrides) {
    const std::string path = split_assignment(assignment).path;
    places[path] = override_place;
    if (path != preset_key) apply_override(c, assignment);
  }
}

Case case_of(const toml::table& root, const std::string& name, std::span<const std::string> overrides,
             KeyPlaces& places) {
  Case c;
  set_preset(c, root, name, overrides, places);
  read_keys(root, name, c, places);
  return c;
}

void refuse_conflicts(const Case& c, const std::string& name, const KeyPlaces& places) {
  const auto conflict = find_conflict(c);
  if (!conflict) return;
  const auto place = places.find(conflict->key);
  throw InputError(fmt::format("{}: {}", place == places.end() ? name : place->second, conflict->message));
}

/// The value of an override; a word needs no quotes.
toml::table parse_value(const Key& key, const std::string& text) {
  Case any;
  const bool quoted = text.starts_with('"') || text.starts_with('\'');
  const bool literal = std::holds_alternative<std::string*>(key.field(any)) && !quoted;
  if (!literal) {
    try {
      toml::table table = parse_toml("value = " + text);
      if (table.size() == 1) return table;
    } catch (const toml::parse_error&) {
      // Not TOML: either a bare word, or a mistake that is reported later with the allowed values.
    }
  }
  return toml::table{{"value", text}};
}

/// Resets the rival of a key (the same quantity in another unit) to its default, so that the key given last
/// counts.
void give_up_rival(const Key& key, Case& c) {
  if (key.rival.empty()) return;
  reset(*find_key(key.table, key.rival), c);
}

/// False for the unused one of two rivals, which set the same quantity in different units. The rival without
/// a default is used if it is given.
bool counts(const Key& key, const Case& c) {
  if (value_text(key, c).empty()) return false;
  const bool absolute = value_text(key, Case{}).empty();
  return key.rival.empty() || absolute || value_text(*find_key(key.table, key.rival), c).empty();
}

}  // namespace

Case parse_case(std::string_view toml, const std::string& name, std::span<const std::string> overrides) {
  KeyPlaces places;
  const toml::table root = parse_text(toml, name);
  refuse_many_cases(root, name);
  Case c = case_of(root, name, overrides, places);
  apply_overrides(c, overrides, places);
  refuse_conflicts(c, name, places);
  return c;
}

toml::table read_table(const std::filesystem::path& file) {
  const std::string name = file.string();
  if (std::filesystem::is_directory(file)) throw InputError(name + ": is a directory; allowed: a case file");
  if (!std::filesystem::exists(file)) throw InputError(name + ": there is no such file");
  return parse_text(read_file(file), name);
}

Case case_in(const toml::table& root, const std::filesystem::path& file,
             std::span<const std::string> overrides) {
  const std::string name = file.string();
  KeyPlaces places;
  Case c = case_of(root, name, overrides, places);
  const std::array<std::pair<const char*, std::string*>, 2> files{
      {{"start.file", &c.start.file}, {"mixture.diameters", &c.mixture.diameters}}};
  for (const auto& [key, value] : files)
    if (!value->empty()) *value = (file.parent_path() / *value).string();
  apply_overrides(c, overrides, places);
  refuse_conflicts(c, name, places);
  for (const auto& [key, value] : files)  // a path in an override is relative to the current directory
    if (!value->empty()) *value = file_path({}, key, *value, places.at(key));
  return c;
}

std::string file_path(const std::filesystem::path& case_file, std::string_view key, const std::string& value,
                      const std::string& place) {
  const std::filesystem::path path = case_file.parent_path() / value;
  if (!std::filesystem::is_regular_file(path))
    throw InputError(fmt::format("{}: {} = \"{}\" is not a file; allowed: the path of {}", place, key,
                                 path.string(), key == "start.file" ? "a packing" : "a list of diameters"));
  return std::filesystem::absolute(path).lexically_normal().string();
}

Case read_case(const std::filesystem::path& file, std::span<const std::string> overrides) {
  const toml::table root = read_table(file);
  refuse_many_cases(root, file.string());
  return case_in(root, file, overrides);
}

void apply_override(Case& c, std::string_view assignment) {
  const auto [path, value] = split_assignment(assignment);
  const Key* const key = find_key(path);
  const auto dot = path.find('.');
  const bool may_be_key = key != nullptr || (dot != std::string::npos && dot + 1 < path.size());
  if (!may_be_key || value.empty())
    throw InputError(
        fmt::format("{}: {} is not an assignment of a key in its table; allowed: table.key=value, e.g. "
                    "contact.friction=0.3",
                    override_place, assignment));
  if (key == nullptr)
    refuse_unknown_key(path.substr(0, dot), path.substr(dot + 1), *toml::table{{"v", value}}.get("v"),
                       override_place);
  assign(*key, *parse_value(*key, value).get("value"), c, override_place);
  give_up_rival(*key, c);
}

namespace {

/// Whether the case has a list of diameters that replaces this key.
bool is_replaced_by_a_list(const Key& key, const Case& c) {
  return !c.mixture.diameters.empty() && key.table == "mixture" &&
         (key.name == "size_ratio" || key.name == "small_fraction" || key.name == "large");
}

}  // namespace

std::string resolved_toml(const Case& c) {
  const std::string_view other_start = c.start.file.empty() ? "start" : "mixture";
  std::string text = "# Every key of the case, with its unit and what it means.\n";
  std::string_view table;
  for (const Key& key : case_keys()) {
    if (key.table == other_start) continue;
    if (key.table != table) text += fmt::format("\n[{}]\n", key.table);
    table = key.table;
    const std::string unit = key.unit.empty() ? "" : fmt::format(" [{}]", key.unit);
    if (is_replaced_by_a_list(key, c))
      text += fmt::format("# {} is not used: diameters is given\n", key.name);
    else if (counts(key, c))
      text +=
          fmt::format("{:<28} #{} {}\n", fmt::format("{} = {}", key.name, value_text(key, c)), unit, key.doc);
    else
      text += fmt::format("# {} is not used: {} is given\n", key.name, key.rival);
  }
  return text;
}

}  // namespace furnas
