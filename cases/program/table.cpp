#include "cases/program/table.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/base/require.h"
#include "io/csv.h"

namespace furnas {

void Table::row(std::vector<std::string> cells) {
  require(cells.size() == names_.size(), "a row has a cell for each name");
  rows_.push_back(std::move(cells));
}

std::string Table::aligned() const {
  std::vector<std::size_t> width;
  for (const std::string& name : names_) width.push_back(name.size());
  for (const auto& cells : rows_)
    for (std::size_t k = 0; k < cells.size(); ++k) width[k] = std::max(width[k], cells[k].size());
  std::string text;
  const auto line = [&](const std::vector<std::string>& cells) {
    for (std::size_t k = 0; k < cells.size(); ++k)
      text += fmt::format("{}{:>{}}", k == 0 ? "" : "  ", cells[k], width[k]);
    text += '\n';
  };
  line(names_);
  for (const auto& cells : rows_) line(cells);
  return text;
}

std::string Table::csv() const {
  std::string text = csv_row(names_);
  for (const std::vector<std::string>& cells : rows_) text += csv_row(cells);
  return text;
}

Spread spread_of(std::vector<double> values) {
  require(!values.empty(), "there is something to spread");
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  const double median = values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
  return {median, values.front(), values.back()};
}

std::string text_of(const Spread& s) {
  return fmt::format("{:.3g} ({:.3g} - {:.3g})", s.median, s.low, s.high);
}

}  // namespace furnas
