#include "cases/program/sweep/sample_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>

#include "cases/program/table.h"
#include "engine/base/numbers.h"
#include "engine/base/require.h"
#include "io/csv.h"

namespace furnas {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// Columns after the keys. Tables of older versions lack the last one.
const std::vector<std::string> columns{"seed",
                                       "large",
                                       "small",
                                       "verdict",
                                       "reason",
                                       "phi_J",
                                       "phi",
                                       "Z",
                                       "Z_backbone",
                                       "backbone",
                                       "large_rattlers_2",
                                       "large_rattlers_3",
                                       "large_rattlers_4",
                                       "small_rattlers_2",
                                       "small_rattlers_3",
                                       "small_rattlers_4",
                                       "steps",
                                       "wall_seconds",
                                       "state_hash",
                                       "phi_bound"};

double number(const Json& value) { return value.is_number() ? value.get<double>() : unknown; }

/// A count; 0 where it is null, as those of species are in a polydisperse packing.
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
  row.phi_J = row.phi = row.phi_bound = row.Z = row.Z_backbone = row.backbone = unknown;
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
    row.large_rattlers.at(n) = count_in(count.at("large"));
    row.small_rattlers.at(n) = count_in(count.at("small"));
    if (least == threshold) row.backbone = number(count.at("backbone"));
  }
  if (row.settled()) row.phi_bound = number(r.at("phi_bound"));
  row.steps = r.at("steps");
  row.wall_seconds = r.at("wall_seconds");
  row.cpu_seconds = number(r.value("cpu_seconds", Json()));
  row.evaluations = r.value("minimizer_evaluations", std::int64_t{0});
  row.state_hash = r.at("state_hash");
}

SampleRow row_of(const Sample& sample) {
  SampleRow row = row_of_case(sample);
  const SampleState state = state_of(sample);
  if (std::ifstream file(sample.folder / "result.json"); file) try {
      take_result(row, Json::parse(file));
    } catch (const Json::exception& error) {
      throw InputError(fmt::format("{}: {}", (sample.folder / "result.json").string(), error.what()));
    }
  if (state == SampleState::finished) return row;
  row.phi_J = row.phi_bound = unknown;
  const std::string said = last_line(sample.log());
  const std::string complaint = "furnas: ";
  row.verdict = said.starts_with(complaint) ? "failed" : "unfinished";
  row.reason = row.verdict == "failed" ? said.substr(complaint.size()) : "";
  return row;
}

std::string cell(double value) { return std::isfinite(value) ? fmt::format("{}", value) : ""; }

/// Takes the cells of a row one after the other.
class Cells {
 public:
  Cells(std::vector<std::string> cells, std::string place)
      : cells_(std::move(cells)), place_(std::move(place)) {}
  std::string text() { return cells_.at(next_++); }
  bool left() const { return next_ < cells_.size(); }
  template <class Number>
  Number number() {
    const std::string text = this->text();
    if constexpr (std::is_floating_point_v<Number>)
      if (text.empty()) return unknown;
    const std::optional<Number> value = number_in<Number>(text);
    if (!value)
      throw InputError(fmt::format("{}: \"{}\" in column {}; allowed: a number", place_, text, next_));
    return *value;
  }

 private:
  std::vector<std::string> cells_;
  std::string place_;
  std::size_t next_ = 0;
};

double value_of(const SampleTable& table, const SampleRow& row, const char* key, double otherwise) {
  const auto found = std::find(table.keys.begin(), table.keys.end(), key);
  if (found == table.keys.end()) return otherwise;
  return Cells({row.values[static_cast<std::size_t>(found - table.keys.begin())]}, key).number<double>();
}

SampleRow row_in(Cells cells, const SampleTable& table) {
  SampleRow row;
  for (std::size_t k = 0; k < table.keys.size(); ++k) row.values.push_back(cells.text());
  row.size_ratio = value_of(table, row, "mixture.size_ratio", 1);
  row.small_fraction = value_of(table, row, "mixture.small_fraction", 0);
  row.friction = value_of(table, row, "contact.friction", 0);
  row.seed = cells.number<std::int64_t>();
  row.large = cells.number<std::int64_t>();
  row.small = cells.number<std::int64_t>();
  row.verdict = cells.text();
  row.reason = cells.text();
  for (double* value : {&row.phi_J, &row.phi, &row.Z, &row.Z_backbone, &row.backbone})
    *value = cells.number<double>();
  for (auto& count : row.large_rattlers) count = cells.number<std::int64_t>();
  for (auto& count : row.small_rattlers) count = cells.number<std::int64_t>();
  row.steps = cells.number<std::int64_t>();
  row.wall_seconds = cells.number<double>();
  row.state_hash = cells.text();
  row.phi_bound = cells.left() ? cells.number<double>() : unknown;
  return row;
}

}  // namespace

SampleTable table_of(const std::vector<Sample>& samples, const std::vector<std::string>& keys) {
  SampleTable table{keys, {}};
  for (const Sample& sample : samples) table.rows.push_back(row_of(sample));
  return table;
}

std::string csv(const SampleTable& table) {
  std::vector<std::string> names = table.keys;
  names.insert(names.end(), columns.begin(), columns.end());
  Table text(names);
  for (const SampleRow& r : table.rows) {
    std::vector<std::string> cells = r.values;
    for (const std::int64_t n : {r.seed, r.large, r.small}) cells.push_back(std::to_string(n));
    for (const std::string& words : {r.verdict, r.reason}) cells.push_back(without_commas(words));
    for (const double x : {r.phi_J, r.phi, r.Z, r.Z_backbone, r.backbone}) cells.push_back(cell(x));
    for (const std::int64_t n : r.large_rattlers) cells.push_back(std::to_string(n));
    for (const std::int64_t n : r.small_rattlers) cells.push_back(std::to_string(n));
    cells.insert(cells.end(),
                 {std::to_string(r.steps), cell(r.wall_seconds), r.state_hash, cell(r.phi_bound)});
    text.row(cells);
  }
  return text.csv();
}

SampleTable read_sample_table(const fs::path& folder) {
  const fs::path path = folder / sample_table_name;
  std::ifstream file(path);
  if (!file) throw InputError(path.string() + " cannot be read; allowed: the folder of a sweep");
  SampleTable table;
  read_csv_row(file, table.keys);
  const std::size_t width = table.keys.size();
  const std::size_t ours = columns.size() - (width > 0 && table.keys.back() != columns.back() ? 1 : 0);
  if (width < ours || !std::equal(columns.begin(), columns.begin() + static_cast<long>(ours),
                                  table.keys.end() - static_cast<long>(ours)))
    throw InputError(path.string() + ":1: other columns than furnas sweep writes");
  table.keys.resize(width - ours);
  std::vector<std::string> cells;
  for (int number = 2; read_csv_row(file, cells); ++number) {
    const std::string place = fmt::format("{}:{}", path.string(), number);
    if (cells.size() != width)
      throw InputError(fmt::format("{}: {} columns; allowed: {}", place, cells.size(), width));
    table.rows.push_back(row_in(Cells(cells, place), table));
  }
  return table;
}

}  // namespace furnas
