#include "io/csv.h"

#include <algorithm>
#include <istream>
#include <optional>
#include <string_view>

#include "engine/base/require.h"
#include "io/text_reader.h"

namespace furnas {
namespace {

std::string in_quotes(const std::string& cell) {
  std::string text = "\"";
  for (const char letter : cell) text += letter == '"' ? "\"\"" : std::string(1, letter);
  return text + '"';
}

/// The place of the closing quote of a text that begins with a quote; empty if it is not closed.
std::optional<std::size_t> closing_quote(std::string_view text) {
  for (std::size_t at = 1; at < text.size(); ++at) {
    if (text[at] != '"') continue;
    if (at + 1 == text.size() || text[at + 1] != '"') return at;
    ++at;  // two quotes mean one
  }
  return {};
}

std::string unquoted(std::string_view inside) {
  std::string text;
  for (std::size_t at = 0; at < inside.size(); ++at) {
    text += inside[at];
    if (inside[at] == '"') ++at;
  }
  return text;
}

/// Takes a cell and the comma after it from the front of a row; empty if its quotes are not closed yet.
std::optional<std::string> take_cell(std::string_view& row, bool& last) {
  std::size_t end = row.find(',');
  std::optional<std::string> cell;
  if (row.starts_with('"')) {
    const std::optional<std::size_t> quote = closing_quote(row);
    if (!quote) return {};
    if (const std::size_t after = *quote + 1; after == row.size() || row[after] == ',') {
      end = after == row.size() ? row.npos : after;
      cell = unquoted(row.substr(1, *quote - 1));
    }
  }
  if (!cell) cell = row.substr(0, end);
  last = end == row.npos;
  if (!last) row.remove_prefix(end + 1);
  return cell;
}

/// The cells of a row; nothing if quotes are not closed yet.
std::optional<std::vector<std::string>> cells_of(std::string_view row) {
  std::vector<std::string> cells;
  for (bool last = false; !last;) {
    std::optional<std::string> cell = take_cell(row, last);
    if (!cell) return {};
    cells.push_back(std::move(*cell));
  }
  return cells;
}

}  // namespace

std::string csv_cell(const std::string& text) {
  return text.find_first_of(",\"\r\n") == text.npos ? text : in_quotes(text);
}

std::string csv_row(const std::vector<std::string>& cells) {
  std::string row;
  for (const std::string& cell : cells) {
    if (&cell != &cells.front()) row += ',';
    row += csv_cell(cell);
  }
  return row + '\n';
}

std::string without_commas(std::string text) {
  std::replace(text.begin(), text.end(), ',', ';');
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

bool read_csv_row(std::istream& file, std::vector<std::string>& cells, const std::string& name) {
  std::string row, line;
  const auto next_line = [&] {
    try {
      return read_line(file, line);
    } catch (const std::ios_base::failure&) {
      throw InputError(name + ": cannot be read any further");
    }
  };
  while (next_line()) {
    if (line.ends_with('\r')) line.pop_back();
    // Only a quote closes a cell that an earlier line has opened.
    const bool may_end = row.empty() || line.find('"') != line.npos;
    row += line;
    if (may_end)
      if (auto found = cells_of(row)) {
        cells = std::move(*found);
        return true;
      }
    row += '\n';
    constexpr std::size_t longest = std::size_t{1} << 20;
    if (row.size() > longest) break;
  }
  if (!row.empty()) throw InputError(name + ": the quotes of a cell are not closed");
  return false;
}

}  // namespace furnas
