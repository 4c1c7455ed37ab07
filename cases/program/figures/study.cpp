#include "cases/program/figures/study.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "cases/program/figures/gather.h"
#include "engine/base/require.h"

namespace furnas {
namespace {

namespace fs = std::filesystem;

std::tuple<double, double, double> place_of(const SampleRow& row) {
  return {row.size_ratio, row.friction, row.small_fraction};
}

/// A key that may differ between samples without friction, whose phi_J hardly depends on it.
struct KeyWithoutFriction {
  const char* key;
  std::string (*stands_for)(
      const std::string& value);           ///< without friction: the value with which it may stand
  bool (*told)(const std::string& value);  ///< whether the reader is told of such samples
};

/// p_a of a run: the last of its pressures. A list is written as [a;b].
std::string last_pressure(const std::string& value) {
  if (!value.ends_with(']')) return value;
  const std::size_t from = value.find_last_of("[;") + 1;
  return value.substr(from, value.size() - from - 1);
}

constexpr const char* solid = "3";
const KeyWithoutFriction free_without_friction[] = {
    // docs/developer/decisions/masses-without-friction.md
    {"compaction.mass_exponent", [](const std::string&) { return std::string(solid); },
     [](const std::string& value) { return value != solid && !value.empty(); }},
    // docs/developer/decisions/from-a-higher-pressure.md
    {"compaction.pressure", last_pressure, [](const std::string& value) { return value.starts_with('['); }},
};

/// The values of a key among the samples with friction or among those without it, and the number of samples
/// of each; empty if the key is the same for all samples.
std::map<std::string, std::size_t> values_of(const Gathered& all, const std::string& key, bool friction) {
  std::map<std::string, std::size_t> values;
  const auto& names = all.table.keys;
  const auto place = std::find(names.begin(), names.end(), key) - names.begin();
  if (place == std::ssize(names)) return values;
  for (const SampleRow& row : all.table.rows)
    if ((row.friction > 0) == friction) ++values[row.values[static_cast<std::size_t>(place)]];
  return values;
}

/// Whether samples that differ in a key may not stand together.
bool separates(const Gathered& all, const std::string& key) {
  for (const KeyWithoutFriction& free : free_without_friction) {
    if (key != free.key) continue;
    std::set<std::string> values;
    for (const auto& [value, count] : values_of(all, key, true)) values.insert(value);
    for (const auto& [value, count] : values_of(all, key, false)) values.insert(free.stands_for(value));
    return values.size() > 1;
  }
  const std::vector<std::string>& free = keys_of_the_paper();
  return key != number_of_large && std::find(free.begin(), free.end(), key) == free.end();
}

/// Refuses samples that differ in keys that the paper does not vary, because their means would mix
/// experiments.
void refuse_other_keys(const Gathered& all, const std::vector<fs::path>& folders) {
  std::string others, first;
  for (const VaryingKey& varying : all.varying()) {
    if (!separates(all, varying.key)) continue;
    if (first.empty()) first = varying.key;
    others +=
        fmt::format("{}{} ({})", others.empty() ? "" : ", ", varying.key, fmt::join(varying.values, ", "));
  }
  std::vector<std::string> names;
  names.reserve(folders.size());
  for (const fs::path& folder : folders) names.push_back(folder.string());
  for (std::size_t k = 0; k < all.runs.size(); ++k)
    if (all.table.rows[k].values.front().empty())
      throw InputError(
          fmt::format("{} has its spheres from a file, and no size ratio; allowed: sweeps over "
                      "mixture.size_ratio, or furnas plot",
                      all.sweeps[k].string()));
  if (others.empty()) return;
  throw InputError(fmt::format(
      "samples in {} differ in {}: their means would mix experiments; allowed: samples that differ in {} and "
      "{} alone. To see the difference: furnas plot {} --by {}",
      fmt::join(names, ", "), others, fmt::join(keys_of_the_paper(), ", "), number_of_large,
      fmt::join(names, " "), first));
}

/// Which samples without friction have other values of a key than the samples beside them.
std::vector<std::string> remarks_without_friction(const Gathered& all) {
  std::vector<std::string> remarks;
  for (const KeyWithoutFriction& free : free_without_friction)
    for (const auto& [value, count] : values_of(all, free.key, false))
      if (free.told(value))
        remarks.push_back(fmt::format("{} without friction {} made with {} = {}",
                                      count == 1 ? "1 sample" : fmt::format("{} samples", count),
                                      count == 1 ? "was" : "were", free.key, value));
  return remarks;
}

/// The history of a jammed sample of the largest size ratio and friction; empty if there is none.
fs::path history_in(const Gathered& all) {
  fs::path history;
  std::tuple<double, double, double> best;
  for (std::size_t k = 0; k < all.runs.size(); ++k) {
    const SampleRow& row = all.table.rows[k];
    const fs::path file = all.runs[k] / "history.csv";
    const std::tuple rank{row.size_ratio, row.friction, row.phi_J};
    if (!row.jammed() || !(history.empty() || rank > best) || !fs::exists(file)) continue;
    best = rank;
    history = file;
  }
  return history;
}

/// A sorted table with the keys of the paper. At each point it has the rows with the most large spheres.
SampleTable largest_of(const Gathered& gathered, std::vector<std::string>& remarks) {
  SampleTable all{keys_of_the_paper(), gathered.table.rows};
  std::map<std::tuple<double, double, double>, std::int64_t> most;
  for (SampleRow& row : all.rows) {
    row.values.resize(all.keys.size());  // keeps the keys of the paper, which are the first
    auto& large = most[place_of(row)];
    large = std::max(large, row.large);
  }
  // A failed sample has no result and so no known size.
  const auto smaller = std::erase_if(
      all.rows, [&](const SampleRow& row) { return row.large > 0 && row.large < most[place_of(row)]; });
  if (smaller > 0)
    remarks.push_back(fmt::format("{} with fewer large spheres than others of the same point {} left out",
                                  smaller == 1 ? "1 sample" : fmt::format("{} samples", smaller),
                                  smaller == 1 ? "is" : "are"));
  std::stable_sort(all.rows.begin(), all.rows.end(),
                   [](const SampleRow& a, const SampleRow& b) { return place_of(a) < place_of(b); });
  return all;
}

}  // namespace

Study study_of(const std::vector<fs::path>& folders) {
  const Gathered gathered = gather(folders);
  refuse_other_keys(gathered, folders);
  Study study;
  study.remarks = gathered.remarks;
  for (std::string& remark : remarks_without_friction(gathered)) study.remarks.push_back(std::move(remark));
  study.history = history_in(gathered);
  study.points = points_of(largest_of(gathered, study.remarks));
  for (const Curve& curve : curves_of(study.points, keys_of_the_paper()))
    if (curve.size_ratio() == 1)
      study.mono.push_back(curve.points.front());
    else
      study.curves.push_back(curve);
  return study;
}

Study Study::without_thin_cells() const {
  Study thick = *this;
  const auto thin = [](const Point& point) { return point.too_thin(); };
  std::erase_if(thick.mono, thin);
  for (Curve& curve : thick.curves) std::erase_if(curve.points, thin);
  std::erase_if(thick.curves, [](const Curve& curve) { return curve.points.empty(); });
  return thick;
}

const Point* Study::mono_at(double friction) const {
  for (const Point& point : mono)
    if (point.friction == friction) return &point;
  return nullptr;
}

std::optional<FurnasInterval> Study::model(double friction) const {
  const Point* point = mono_at(friction);
  if (point == nullptr) return {};
  return furnas_model_of(*point->mean_phi_J);
}

FurnasInterval furnas_model_of(const MeanInterval& phi) {
  if (phi.samples < 2) return FurnasInterval(phi.mean, 0);
  // The interval of two very different samples can reach below 0 or above 1.
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
