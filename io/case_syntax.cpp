#include "io/case_syntax.h"

#include <fmt/format.h>

#include "io/case_schema.h"
#include "io/case_words.h"

namespace furnas {
namespace {

constexpr std::string_view blanks = " \t\r\n";

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::string_view without_comment(std::string_view line) { return trimmed(line.substr(0, line.find('#'))); }

/// A line of the file, counted from 1, and the table that it belongs to.
struct Line {
  std::string_view text;
  std::string_view table;
};

Line find_line(std::string_view text, std::size_t number) {
  Line found;
  for (std::size_t n = 1; n <= number; ++n) {
    const auto end = text.find('\n');
    found.text = without_comment(text.substr(0, end));
    if (n < number && found.text.starts_with('[') && found.text.ends_with(']'))
      found.table = trimmed(found.text.substr(1, found.text.size() - 2));
    if (end == std::string_view::npos) break;
    text.remove_prefix(end + 1);
  }
  return found;
}

}  // namespace

Assignment split_assignment(std::string_view text) {
  const auto equals = text.find('=');
  if (equals == std::string_view::npos) return {std::string(trimmed(text)), {}};
  return {std::string(trimmed(text.substr(0, equals))), std::string(trimmed(text.substr(equals + 1)))};
}

std::string explain_syntax(std::string_view text, const std::string& name, std::size_t line,
                           std::string_view complaint) {
  const Line place = find_line(text, line);
  const auto [key_name, value] = split_assignment(place.text);
  const bool assigns = place.text.find('=') != std::string_view::npos;
  const bool twice = complaint.find("redefine") != std::string_view::npos;

  std::string what(place.text);
  if (assigns)
    what = fmt::format("{}{}{} = {}", place.table, place.table.empty() ? "" : ".", key_name, value);
  if (twice) return fmt::format("{}:{}: {} is given a second time; allowed: once", name, line, what);

  const Key* key = assigns ? find_key(place.table, key_name) : nullptr;
  const std::string allowed = key == nullptr ? "" : "; allowed: " + allowed_text(*key);
  return fmt::format("{}:{}: {} cannot be read{} ({})", name, line, what, allowed, complaint);
}

}  // namespace furnas
