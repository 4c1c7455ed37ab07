#include "cases/program/sweep/sample_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>

#include "cases/program/sweep/sample_columns.h"
#include "cases/program/table.h"
#include "engine/base/numbers.h"
#include "engine/base/require.h"
#include "io/csv.h"

namespace furnas {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr double unknown = SampleRow::unknown;

double number(const Json& value) { return value.is_number() ? value.get<double>() : unknown; }

/// A count; 0 where it is null, as counts of a species are in a polydisperse packing.
std::int64_t count_in(const Json& value) { return value.is_null() ? 0 : value.get<std::int64_t>(); }

/// The last line that a process printed.
std::string last_line(const fs::path& log) {
  std::ifstream file(log);
  std::string last;
  for (std::string line; std::getline(file, line);)
    if (!line.empty()) last = line;
  return last;
}

SampleRow row_of_case(const Sample& sample) {
  SampleRow row;
  const Case& c = sample.resolved_case;
  row.values = sample.values;
  row.size_ratio = c.mixture.size_ratio;
  row.small_fraction = c.mixture.small_fraction;
  row.friction = c.contact.friction;
  row.seed = c.mixture.seed;
  row.pressure = c.compaction.pressure.back();
  row.preset = c.preset;
  return row;
}

void take_result(SampleRow& row, const Json& r) {
  row.large = count_in(r.at("large"));
  row.small = count_in(r.at("small"));
  row.verdict = r.at("verdict");
  row.reason = r.at("reason");
  row.phi_J = number(r.at("phi_J"));
  row.phi = number(r.at("phi"));
  row.Z = number(r.at("Z"));
  row.Z_backbone = number(r.at("Z_backbone"));
  const int threshold = r.at("backbone_threshold");
  for (const Json& count : r.at("rattlers")) {
    const int least = count.at("least_contacts");
    const auto n = static_cast<std::size_t>(least - 2);
    if (n >= row.large_rattlers.size())
      throw InputError(fmt::format("least_contacts is {}; allowed: 2, 3 and 4", least));
    row.large_rattlers[n] = count_in(count.at("large"));
    row.small_rattlers[n] = count_in(count.at("small"));
    if (least == threshold) row.backbone = number(count.at("backbone"));
  }
  if (row.settled()) row.phi_bound = number(r.at("phi_bound"));
  row.thickness = number(r.value("thickness_in_largest_diameters", Json()));
  row.steps = r.at("steps");
  row.wall_seconds = r.at("wall_seconds");
  row.cpu_seconds = number(r.value("cpu_seconds", Json()));
  row.evaluations = r.value("minimizer_evaluations", std::int64_t{0});
  row.state_hash = r.at("state_hash");
}

SampleRow row_of(const Sample& sample) {
  SampleRow row = row_of_case(sample);
  const SampleState state = state_of(sample);
  const auto refused = [&](const std::exception& error) {
    return InputError(fmt::format("{}: {}", (sample.folder / "result.json").string(), error.what()));
  };
  if (std::ifstream file(sample.folder / "result.json"); file) try {
      take_result(row, Json::parse(file));
    } catch (const Json::exception& error) {
      throw refused(error);
    } catch (const InputError& error) {
      throw refused(error);
    }
  if (state == SampleState::finished) return row;
  row.phi_J = row.phi_bound = unknown;
  const std::string said = last_line(sample.log());
  const std::string complaint = "furnas: ";
  row.verdict = said.starts_with(complaint) ? "failed" : "unfinished";
  row.reason = row.verdict == "failed" ? said.substr(complaint.size()) : "";
  return row;
}

/// Puts the text of a cell into a row; an empty cell is an unknown number, or a count of 0.
void take_cell(const SampleColumn& column, const std::string& text, SampleRow& row,
               const std::string& place) {
  const auto refused = [&] {
    return InputError(
        fmt::format("{}: \"{}\" in column {}; allowed: a number", place, text, column.about.name));
  };
  std::visit(
      [&](auto* field) {
        using Type = std::decay_t<decltype(*field)>;
        if constexpr (std::is_same_v<Type, std::string>) {
          *field = text;
        } else {
          const Type unknown_here =
              std::is_floating_point_v<Type> ? std::numeric_limits<Type>::quiet_NaN() : 0;
          const std::optional<Type> value = text.empty() ? unknown_here : number_in<Type>(text);
          if (!value) throw refused();
          *field = *value;
        }
      },
      column.value(row));
}

double value_of(const SampleTable& table, const SampleRow& row, const char* key, double otherwise,
                const std::string& place) {
  const auto found = std::find(table.keys.begin(), table.keys.end(), key);
  if (found == table.keys.end()) return otherwise;
  const std::string& text = row.values[static_cast<std::size_t>(found - table.keys.begin())];
  const std::optional<double> value = number_in<double>(text);
  if (!value) throw InputError(fmt::format("{}: \"{}\" in column {}; allowed: a number", place, text, key));
  return *value;
}

SampleRow row_in(const std::vector<std::string>& cells, const SampleTable& table, const std::string& place) {
  SampleRow row;
  const auto keys = static_cast<std::ptrdiff_t>(table.keys.size());
  row.values.assign(cells.begin(), cells.begin() + keys);
  row.size_ratio = value_of(table, row, "mixture.size_ratio", 1, place);
  row.small_fraction = value_of(table, row, fraction_key, 0, place);
  row.friction = value_of(table, row, "contact.friction", 0, place);
  for (std::size_t k = table.keys.size(); k < cells.size(); ++k)
    take_cell(sample_columns()[k - table.keys.size()], cells[k], row, place);
  return row;
}

/// Removes the columns of furnas from the names, so that the keys remain. Returns the number of removed
/// columns; 0 if the columns are different ones.
std::size_t take_columns(std::vector<std::string>& names) {
  const auto columns = sample_columns();
  const auto first = std::find(names.begin(), names.end(), columns.front().about.name);
  const auto count = static_cast<std::size_t>(names.end() - first);
  if (count < oldest_sample_columns || count > columns.size()) return 0;
  for (std::size_t k = 0; k < count; ++k)
    if (first[static_cast<std::ptrdiff_t>(k)] != columns[k].about.name) return 0;
  names.erase(first, names.end());
  return count;
}

}  // namespace

void VerdictCounts::count(const SampleRow& row) {
  ++samples;
  ++(row.jammed()                ? jammed
     : row.settled()             ? settled
     : row.verdict == "budget"   ? budget
     : row.verdict == "diverged" ? diverged
     : row.verdict == "failed"   ? failed
                                 : unfinished);
}

SampleTable table_of(const std::vector<Sample>& samples, const std::vector<std::string>& keys) {
  SampleTable table{keys, {}};
  for (const Sample& sample : samples) table.rows.push_back(row_of(sample));
  return table;
}

std::string csv(const SampleTable& table) {
  std::vector<std::string> names = table.keys;
  for (const SampleColumn& column : sample_columns()) names.emplace_back(column.about.name);
  Table text(names);
  for (const SampleRow& row : table.rows) {
    std::vector<std::string> cells = row.values;
    for (const SampleColumn& column : sample_columns()) cells.push_back(cell_of(column, row));
    text.row(cells);
  }
  return text.csv();
}

SampleTable read_sample_table(const fs::path& folder) {
  const fs::path path = folder / sample_table_name;
  std::ifstream file(path);
  if (!file) throw InputError(path.string() + " cannot be read; allowed: the folder of a sweep");
  SampleTable table;
  read_csv_row(file, table.keys, path.string());
  const std::size_t width = table.keys.size();
  if (take_columns(table.keys) == 0)
    throw InputError(path.string() + ":1: the columns are not those that furnas sweep writes");
  std::vector<std::string> cells;
  for (int number = 2; read_csv_row(file, cells, path.string()); ++number) {
    const std::string place = fmt::format("{}:{}", path.string(), number);
    if (cells.size() != width)
      throw InputError(fmt::format("{}: {} columns; allowed: {}", place, cells.size(), width));
    table.rows.push_back(row_in(cells, table, place));
  }
  return table;
}

}  // namespace furnas
