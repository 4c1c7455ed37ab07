#include "cases/program/sweep/maxima.h"

#include <fmt/format.h>

#include "cases/program/sweep/refinement.h"
#include "cases/program/table.h"

namespace furnas {
namespace {

std::string fraction(double f) { return fmt::format("{:.4f}", f); }

const MaximumColumn maximum_column_table[] = {
    {{"points", "", "total", "points of the curve"},
     [](const Curve& curve, const CurveMaximum&) { return std::to_string(curve.points.size()); }},
    {{"f_max", "", "curve", "f_s at which phi_J is highest, by a fit to the samples around it"},
     [](const Curve&, const CurveMaximum& m) { return fraction(m.f_max); }},
    {{"f_max_low", "", "curve", "lower end of its 95 % interval"},
     [](const Curve&, const CurveMaximum& m) { return fraction(m.f_max_low); }},
    {{"f_max_high", "", "curve", "upper end of its 95 % interval"},
     [](const Curve&, const CurveMaximum& m) { return fraction(m.f_max_high); }},
    {{"known", "", "curve", "yes if f_max is known to +-0.01"},
     [](const Curve&, const CurveMaximum& m) -> std::string {
       return m.f_max_high - m.f_max_low <= 2 * wanted_f_max ? "yes" : "no";
     }},
    {{"phi_max", "", "mean of the samples", "phi_J of the highest point"},
     [](const Curve&, const CurveMaximum& m) { return fmt::format("{:.5f}", m.phi_max.mean); }},
    {{"phi_max_half_width", "", "mean of the samples",
      "half of its 95 % interval, plus the mean of the bounds of settled samples; empty for a single sample"},
     [](const Curve&, const CurveMaximum& m) {
       return m.phi_max.samples > 1 ? fmt::format("{:.5f}", m.phi_max.half_width) : "";
     }},
    {{"phi_max_samples", "", "total", "samples of the highest point"},
     [](const Curve&, const CurveMaximum& m) { return std::to_string(m.phi_max.samples); }},
};

}  // namespace

std::span<const MaximumColumn> maximum_columns() { return maximum_column_table; }

std::string maxima_csv(const std::vector<Curve>& curves, const std::vector<std::string>& keys) {
  std::vector<std::string> names;
  std::vector<std::size_t> places;
  for (std::size_t k = 0; k < keys.size(); ++k)
    if (keys[k] != fraction_key) {
      names.push_back(keys[k]);
      places.push_back(k);
    }
  for (const MaximumColumn& column : maximum_column_table) names.emplace_back(column.about.name);
  Table table(names);
  for (const Curve& curve : curves) {
    const auto maximum = maximum_of(curve);
    if (!maximum) continue;
    std::vector<std::string> cells;
    cells.reserve(names.size());
    for (const std::size_t k : places) cells.push_back(curve.points.front().values[k]);
    for (const MaximumColumn& column : maximum_column_table) cells.push_back(column.cell(curve, *maximum));
    table.row(cells);
  }
  return table.csv();
}

}  // namespace furnas
