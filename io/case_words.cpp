#include "io/case_words.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numeric>
#include <type_traits>

namespace furnas {
namespace {

/// A real number as TOML reads it back to the same bits.
std::string real_text(double value) {
  std::string text = fmt::format("{}", value);
  if (text.find_first_of(".en") == std::string::npos) text += ".0";
  return text;
}

std::string in_quotes(std::string_view word) {
  std::string text = "\"";
  for (const char letter : word) {
    const auto code = static_cast<unsigned char>(letter);
    if (letter == '"' || letter == '\\')
      text += fmt::format("\\{}", letter);
    else if (code < 0x20 || code == 0x7f)
      text += fmt::format("\\u{:04X}", code);
    else
      text += letter;
  }
  return text + '"';
}

std::string text_of(bool value) { return value ? "true" : "false"; }
std::string text_of(int value) { return std::to_string(value); }
std::string text_of(std::int64_t value) { return std::to_string(value); }
std::string text_of(double value) { return real_text(value); }
std::string text_of(const std::string& value) { return in_quotes(value); }

std::string text_of(const std::vector<double>& values) {
  if (values.size() == 1) return real_text(values.front());
  std::vector<std::string> texts(values.size());
  std::transform(values.begin(), values.end(), texts.begin(), real_text);
  return fmt::format("[{}]", fmt::join(texts, ", "));
}

std::string range_text(const Range& range, std::string_view name) {
  return fmt::format("{} {} {} {} {}", range.least, range.above_least ? "<" : "<=", name,
                     range.below_most ? "<" : "<=", range.most);
}

/// Levenshtein's distance: the fewest letters inserted, removed or replaced.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t exchanged = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({exchanged, row[j] + 1, diagonal + 1});
    }
  }
  return row.back();
}

/// Two words are similar if less than half of the letters differ.
bool alike(std::size_t distance, std::string_view a, std::string_view b) {
  return 2 * distance < std::max(a.size(), b.size());
}

}  // namespace

std::string nearest_key(std::string_view table, std::string_view name) {
  const Key* nearest = nullptr;
  std::size_t shortest = 0;
  for (const Key& key : case_keys()) {
    const std::size_t letters = edit_distance(name, key.name);
    // Among equally near keys one of the same table wins, but the right name in the wrong table is found too.
    const std::size_t distance = 2 * letters + (key.table == table ? 0 : 1);
    if (alike(letters, name, key.name) && (nearest == nullptr || distance < shortest)) {
      nearest = &key;
      shortest = distance;
    }
  }
  return nearest == nullptr ? std::string{} : nearest->path();
}

std::string nearest_table(std::string_view table) {
  const auto tables = case_tables();
  const auto distance = [&](std::string_view known) { return edit_distance(table, known); };
  const auto nearest = std::min_element(tables.begin(), tables.end(),
                                        [&](auto a, auto b) { return distance(a) < distance(b); });
  return alike(distance(*nearest), table, *nearest) ? std::string(*nearest) : std::string{};
}

std::string allowed_text(const Key& key) {
  Case defaults;
  const Field field = key.field(defaults);
  std::string text;
  if (const auto* range = std::get_if<Range>(&key.allowed)) {
    text = range_text(*range, key.name);
  } else if (const auto* choices = std::get_if<Choices>(&key.allowed)) {
    std::vector<std::string> words(choices->size());
    std::transform(choices->begin(), choices->end(), words.begin(), in_quotes);
    text = fmt::format("{}", fmt::join(words, " or "));
  } else {
    text = std::holds_alternative<bool*>(field) ? "true or false" : "any text in quotes";
  }
  if (std::holds_alternative<std::vector<double>*>(field)) text += ", one number or a list of them";
  if (!key.when_empty.empty()) text = fmt::format("{} or {}", in_quotes(key.when_empty), text);
  return text;
}

std::string type_text(const Key& key) {
  struct Name {
    std::string operator()(bool*) const { return "boolean"; }
    std::string operator()(int*) const { return "integer"; }
    std::string operator()(std::int64_t*) const { return "integer"; }
    std::string operator()(double*) const { return "real"; }
    std::string operator()(std::string*) const { return "text"; }
    std::string operator()(std::vector<double>*) const { return "real or list of reals"; }
    std::string operator()(std::optional<int>*) const { return "integer"; }
    std::string operator()(std::optional<double>*) const { return "real"; }
  };
  Case defaults;
  const std::string type = std::visit(Name{}, key.field(defaults));
  return key.when_empty.empty() ? type : fmt::format("{} or {}", type, in_quotes(key.when_empty));
}

std::string value_text(const Key& key, const Case& c) {
  // A key gives access to its field for reading and for writing; the copy protects `c`.
  Case copy = c;
  const auto text = [&](auto* field) -> std::string {
    using Value = std::decay_t<decltype(*field)>;
    if constexpr (std::is_same_v<Value, std::optional<int>> || std::is_same_v<Value, std::optional<double>>) {
      if (field->has_value()) return text_of(**field);
      return key.when_empty.empty() ? std::string{} : in_quotes(key.when_empty);
    } else {
      return text_of(*field);
    }
  };
  return std::visit(text, key.field(copy));
}

}  // namespace furnas
