#include "cases/program/figures/plot.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "cases/program/figures/curves_chart.h"
#include "cases/program/figures/gather.h"
#include "cases/program/figures/quantity.h"
#include "engine/base/numbers.h"
#include "engine/base/require.h"

namespace furnas {
namespace {

/// Finds a key by its full name, its name without the table, or its symbol.
std::string key_named(const std::string& name, const Gathered& all, const char* option) {
  for (const std::string& key : all.table.keys)
    if (key == name || name_in(key) == name || key == key_of_symbol(name)) return key;
  throw InputError(fmt::format("{} {}: these sweeps have no such key; allowed: {}", option, name,
                               fmt::join(all.table.keys, ", ")));
}

std::size_t place_of(const Gathered& all, const std::string& key) {
  return static_cast<std::size_t>(std::find(all.table.keys.begin(), all.table.keys.end(), key) -
                                  all.table.keys.begin());
}

/// Removes the rows for which `out` is true.
template <class Out>
void leave_out(Gathered& all, Out&& out) {
  Gathered kept{{all.table.keys, {}}, {}, {}, all.remarks};
  for (std::size_t k = 0; k < all.runs.size(); ++k) {
    if (out(all.table.rows[k])) continue;
    kept.table.rows.push_back(std::move(all.table.rows[k]));
    kept.runs.push_back(std::move(all.runs[k]));
    kept.sweeps.push_back(std::move(all.sweeps[k]));
  }
  all = std::move(kept);
}

/// Applies --where "key=value".
void choose(Gathered& all, const std::string& where) {
  const std::size_t equals = where.find('=');
  if (equals == where.npos)
    throw InputError(fmt::format("--where {}: allowed: key=value, like friction=0.3", where));
  const std::string key = key_named(where.substr(0, equals), all, "--where");
  const std::size_t place = place_of(all, key);
  std::string value = where.substr(equals + 1);
  if (const auto number = number_in<double>(value)) value = fmt::format("{}", *number);
  std::set<std::string> known;
  for (const SampleRow& row : all.table.rows) known.insert(row.values[place]);
  leave_out(all, [&](const SampleRow& row) { return row.values[place] != value; });
  if (all.table.rows.empty())
    throw InputError(
        fmt::format("--where {}: no sample has that; allowed: {} = {}", where, key, fmt::join(known, ", ")));
}

/// The default key for x.
std::string obvious_x(const std::vector<VaryingKey>& varying) {
  std::vector<std::string> numbers;
  for (const VaryingKey& v : varying)
    if (v.key != number_of_large && v.key != "mixture.size_ratio" && number_in<double>(v.values.front()))
      numbers.push_back(v.key);
  if (std::find(numbers.begin(), numbers.end(), fraction_key) != numbers.end()) return fraction_key;
  if (numbers.size() == 1) return numbers.front();
  std::vector<std::string> all;
  all.reserve(varying.size());
  for (const VaryingKey& v : varying) all.push_back(v.key);
  throw InputError(
      fmt::format("--x is missing; allowed: a key of several values: {}",
                  all.empty() ? "these samples have none" : fmt::format("{}", fmt::join(all, ", "))));
}

/// Refuses points whose samples differ in a further key.
void refuse_mixed_points(const std::vector<CurveOfSamples>& curves, const Gathered& all,
                         const std::string& x_key) {
  for (const CurveOfSamples& curve : curves)
    for (const auto& [x, rows] : curve.points)
      for (std::size_t k = 0; k < all.table.keys.size(); ++k) {
        std::set<std::string> values;
        for (const std::size_t row : rows) values.insert(all.table.rows[row].values[k]);
        if (values.size() < 2) continue;
        const std::string& key = all.table.keys[k];
        throw InputError(fmt::format(
            "samples at {} = {} of one curve differ in {} ({}): their mean would mix experiments; allowed: "
            "--by {} as well, or --where {}={}",
            x_key, x, key, fmt::join(values, ", "), key, key, *values.rbegin()));
      }
}

std::vector<CurveOfSamples> curves_by(const Gathered& all, const std::string& x,
                                      const std::vector<std::string>& by) {
  const std::size_t place = place_of(all, x);
  std::map<std::vector<std::string>, CurveOfSamples> curves;
  for (std::size_t k = 0; k < all.runs.size(); ++k) {
    const SampleRow& row = all.table.rows[k];
    const auto at = number_in<double>(row.values[place]);
    if (!at)
      throw InputError(
          fmt::format("--x {}: \"{}\" is no number; allowed: a key of numbers", x, row.values[place]));
    std::vector<std::string> values;
    values.reserve(by.size());
    for (const std::string& key : by) values.push_back(row.values[place_of(all, key)]);
    CurveOfSamples& curve = curves[values];
    curve.values = values;
    curve.points[*at].push_back(k);
  }
  std::vector<CurveOfSamples> sorted;
  sorted.reserve(curves.size());
  for (auto& [values, curve] : curves) sorted.push_back(std::move(curve));
  std::stable_sort(sorted.begin(), sorted.end(), [](const CurveOfSamples& a, const CurveOfSamples& b) {
    for (std::size_t k = 0; k < a.values.size(); ++k) {
      const double one = number_in<double>(a.values[k]).value_or(HUGE_VAL);
      const double other = number_in<double>(b.values[k]).value_or(HUGE_VAL);
      if (one != other) return one < other;
    }
    return a.values < b.values;
  });
  return sorted;
}

}  // namespace

Plot plot_of(const PlotOrder& order) {
  const auto nothing_known = [](const SampleRow& row) { return !row.jammed() && !row.settled(); };
  Gathered all = gather(order.sweeps);
  Gathered equal = all;
  const std::size_t size_ratio = place_of(equal, "mixture.size_ratio");
  leave_out(equal, [&](const SampleRow& row) { return row.values[size_ratio] != "1" || nothing_known(row); });
  for (const std::string& where : order.where) choose(all, where);
  const std::size_t before = all.runs.size();
  leave_out(all, nothing_known);
  if (all.runs.empty())
    throw InputError("these sweeps have no jammed or settled sample that could be plotted");
  Plot plot;
  plot.x = order.x.empty() ? obvious_x(all.varying()) : key_named(order.x, all, "--x");
  std::vector<std::string> by;
  for (const std::string& key : order.by) by.push_back(key_named(key, all, "--by"));
  if (order.by.empty())
    for (const VaryingKey& varying : all.varying())
      if (varying.key != plot.x && varying.key != number_of_large) by.push_back(varying.key);
  const Quantity quantity = quantity_named(order.y);
  plot.y = quantity.name;
  std::vector<CurveOfSamples> curves = curves_by(all, plot.x, by);
  refuse_mixed_points(curves, all, plot.x);
  plot.remarks = all.remarks;
  if (before > all.runs.size())
    plot.remarks.push_back(fmt::format("{} of {} samples are neither jammed nor settled and left out",
                                       before - all.runs.size(), before));
  plot.chart = chart_of(curves, {all, equal, quantity, plot.x, by}, plot.remarks);
  plot.name = fmt::format("{}_against_{}", plot.y, name_in(plot.x));
  for (std::size_t k = 0; k < by.size(); ++k)
    plot.name += fmt::format("{}{}", k == 0 ? "_by_" : "_and_", name_in(by[k]));
  std::replace(plot.name.begin(), plot.name.end(), '/', '_');
  return plot;
}

}  // namespace furnas
