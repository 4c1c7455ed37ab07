#include "cases/program/bench/tradeoff/known_bias.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <sstream>
#include <tuple>

#include "cases/program/sweep/base_case.h"
#include "engine/base/numbers.h"
#include "io/case_file.h"
#include "io/case_protocol.h"
#include "io/case_schema.h"
#include "io/case_words.h"
#include "io/csv.h"

namespace furnas {
namespace {

using Row = std::map<std::string, std::string>;

std::vector<Row> rows_of(std::string_view table) {
  std::istringstream file{std::string(table)};
  std::vector<std::string> names, cells;
  read_csv_row(file, names, "the stored table of biases");
  std::vector<Row> rows;
  while (read_csv_row(file, cells, "the stored table of biases"))
    for (std::size_t k = rows.size(), n = (rows.emplace_back(), 0); n < std::min(names.size(), cells.size());
         ++n)
      rows[k][names[n]] = cells[n];
  return rows;
}

/// The case that settings make, which blanks separate.
Case case_with(const std::string& settings) {
  std::istringstream words(settings);
  std::vector<std::string> set;
  for (std::string word; words >> word;) set.push_back(word);
  return parse_case("", "the stored table of biases", set);
}

/// Keys that change phi_J and in which two cases differ. Which spheres there are is another matter.
std::set<std::string> difference_of(const Case& a, const Case& b) {
  std::set<std::string> keys;
  for (const Key& key : case_keys()) {
    const bool mixture = key.table == "mixture" && key.name != "start_fraction";
    const bool bears = bears_on_phi_J(key) || key.path() == "compute.precision";
    if (bears && !mixture && key.path() != "contact.friction" && value_text(key, a) != value_text(key, b))
      keys.insert(key.path());
  }
  return keys;
}

/// How unlike two mixtures are: first whether there is friction, then the size ratio, then f_s.
std::tuple<bool, double, double> distance(const Case& a, const Case& b) {
  return {(a.contact.friction > 0) != (b.contact.friction > 0),
          std::abs(std::log(large_diameter(mixture_of(a)) / large_diameter(mixture_of(b)))),
          std::abs(a.mixture.small_fraction - b.mixture.small_fraction)};
}

std::string sentence_of(const Row& row) {
  const std::string& set = row.at("arm_settings");
  const std::string settings = set.empty() ? "default settings" : set;
  const std::string where =
      fmt::format("{}: {} samples, furnas {}", row.at("case_settings"), row.at("n"), row.at("version"));
  const auto difference = number_in<double>(row.at("difference"));
  if (!difference) return fmt::format("{}: no sample came to rest ({})", settings, where);
  const auto half_width = number_in<double>(row.at("difference_half_width"));
  const std::string interval =
      half_width ? fmt::format("+- {:.4f} (95 %)", *half_width) : "(without interval)";
  const std::string& standing = row.at("standing");
  const char* const same = standing == "equivalent"  ? "is"
                           : standing == "different" ? "is not"
                                                     : "may or may not be";
  return fmt::format(
      "{}: phi_J differs by {:+.4f} {} from that of the most careful settings, so it {} the same "
      "within {} ({})",
      settings, *difference, interval, same, row.at("margin"), where);
}

}  // namespace

std::vector<std::string> known_biases(const Case& c, std::string_view table) {
  // None of these was measured.
  if (!c.start.file.empty() || !c.mixture.diameters.empty() || c.compaction.cell == "fixed") return {};
  std::vector<Row> rows = rows_of(table);
  std::erase_if(rows, [](const Row& row) {
    return row.at("arm").empty() || row.at("standing") == "reference" || row.at("standing") == "unfinished" ||
           (row.at("arm_settings").empty() && row.at("arm") != "default");
  });
  const auto nearest = std::min_element(rows.begin(), rows.end(), [&](const Row& a, const Row& b) {
    return distance(c, case_with(a.at("case_settings"))) < distance(c, case_with(b.at("case_settings")));
  });
  if (nearest == rows.end()) return {};
  const std::string where = nearest->at("case_settings");
  const Case base = case_with(where);
  if (std::get<0>(distance(c, base))) return {};
  std::vector<std::pair<std::set<std::string>, std::string>> found;
  for (const Row& row : rows) {
    if (row.at("case_settings") != where) continue;
    const Case arm = case_with(where + " " + row.at("arm_settings"));
    const auto changed = difference_of(arm, base), still_other = difference_of(arm, c);
    const bool has_all = std::none_of(changed.begin(), changed.end(),
                                      [&](const std::string& key) { return still_other.contains(key); });
    const bool of_size = changed.empty() && !row.at("arm_settings").empty();  // it changes mixture.large
    if (has_all && !of_size) found.emplace_back(changed, sentence_of(row));
  }
  // An arm whose keys another arm has, too, says less.
  std::vector<std::string> sentences;
  for (const auto& [keys, sentence] : found)
    if (std::none_of(found.begin(), found.end(), [&, &mine = keys](const auto& other) {
          return other.first.size() > mine.size() &&
                 std::includes(other.first.begin(), other.first.end(), mine.begin(), mine.end());
        }))
      sentences.push_back(sentence);
  return sentences;
}

}  // namespace furnas
