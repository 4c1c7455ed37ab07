#include "cases/program/figures/study.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "engine/base/require.h"

namespace furnas {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> keys{"mixture.size_ratio", "mixture.small_fraction", "contact.friction"};

std::tuple<double, double, double> place_of(const SampleRow& row) {
  return {row.size_ratio, row.friction, row.small_fraction};
}

void refuse_other_keys(const SampleTable& table, const fs::path& folder) {
  for (const std::string& key : table.keys)
    if (key != "mixture.large" && std::find(keys.begin(), keys.end(), key) == keys.end())
      throw InputError(fmt::format("{}: {} takes several values; allowed: sweeps over {} and mixture.large",
                                   (folder / sample_table_name).string(), key, fmt::join(keys, ", ")));
}

/// All rows in one table of the paper's keys, sorted.
SampleTable merged(const std::vector<fs::path>& folders, fs::path& history) {
  SampleTable all{keys, {}};
  std::map<std::tuple<double, double, double>, std::int64_t> most;
  std::tuple<double, double, double> best;
  for (const fs::path& folder : folders) {
    const SampleTable table = read_sample_table(folder);
    refuse_other_keys(table, folder);
    for (SampleRow row : table.rows) {
      const fs::path file = folder / folder_of_sample(table.keys, row.values, row.seed) / "history.csv";
      const std::tuple rank{row.size_ratio, row.friction, row.phi_J};
      if (row.jammed() && (history.empty() || rank > best) && fs::exists(file)) {
        best = rank;
        history = file;
      }
      row.values = {fmt::format("{}", row.size_ratio), fmt::format("{}", row.small_fraction),
                    fmt::format("{}", row.friction)};
      auto& large = most[place_of(row)];
      large = std::max(large, row.large);
      all.rows.push_back(std::move(row));
    }
  }
  // The same run in two folders is one sample.
  const auto name_of = [](const SampleRow& row) {
    return std::tuple(place_of(row), row.seed, row.large, row.verdict, row.state_hash);
  };
  std::set<decltype(name_of(SampleRow{}))> seen;
  std::erase_if(all.rows, [&](const SampleRow& row) { return !seen.insert(name_of(row)).second; });
  // A failed sample has no result that would tell its size.
  std::erase_if(all.rows,
                [&](const SampleRow& row) { return row.large > 0 && row.large < most[place_of(row)]; });
  std::stable_sort(all.rows.begin(), all.rows.end(),
                   [](const SampleRow& a, const SampleRow& b) { return place_of(a) < place_of(b); });
  return all;
}

}  // namespace

Study study_of(const std::vector<fs::path>& folders) {
  Study study;
  study.points = points_of(merged(folders, study.history));
  for (const Curve& curve : curves_of(study.points, keys))
    if (curve.size_ratio() == 1)
      study.mono.push_back(curve.points.front());
    else
      study.curves.push_back(curve);
  return study;
}

const Point* Study::mono_at(double friction) const {
  for (const Point& point : mono)
    if (point.friction == friction) return &point;
  return nullptr;
}

std::optional<FurnasInterval> Study::model(double friction) const {
  const Point* point = mono_at(friction);
  if (point == nullptr) return {};
  const MeanInterval& phi = *point->mean_phi_J;
  if (phi.samples < 2) return FurnasInterval(phi.mean, 0);
  // The interval of two samples that differ can reach below 0 or above 1.
  constexpr double emptiest = 1e-3, fullest = 1 - emptiest;
  return FurnasInterval(Interval{phi.mean, std::max(phi.low(), emptiest), std::min(phi.high(), fullest)});
}

const Curve* Study::curve(double size_ratio, double friction) const {
  for (const Curve& c : curves)
    if (c.size_ratio() == size_ratio && c.friction() == friction) return &c;
  return nullptr;
}

std::vector<double> Study::frictions() const {
  std::set<double> all;
  for (const Curve& c : curves) all.insert(c.friction());
  return {all.begin(), all.end()};
}

std::vector<double> Study::size_ratios() const {
  std::set<double> all;
  for (const Curve& c : curves) all.insert(c.size_ratio());
  return {all.begin(), all.end()};
}

}  // namespace furnas
