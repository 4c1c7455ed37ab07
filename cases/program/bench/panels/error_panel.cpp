#include "cases/program/bench/panels/error_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace furnas {
namespace {

/// A curve of the chart: one kind of error in one precision, over the packings.
struct ErrorLine {
  const char* name;
  double ForceError::*error;
  Marker marker;
};

}  // namespace

PanelResult panel_of(const std::vector<ForceErrorRow>& rows) {
  Table table({"packing", "N", "mu", "precision", "contacts", "median", "largest", "missed", "spurious"});
  std::vector<std::string> packings, precisions;
  const auto place_in = [](std::vector<std::string>& names, const std::string& name) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found != names.end()) return static_cast<double>(found - names.begin()) + 1;
    names.push_back(name);
    return static_cast<double>(names.size());
  };
  const ErrorLine lines[] = {{"median", &ForceError::median, Marker::circle},
                             {"largest", &ForceError::largest, Marker::diamond}};
  Chart chart;
  chart.y.title = "error of a contact force, relative";
  chart.x.title = "packing, in the order of the table";
  chart.y.logarithmic = true;
  chart.x.low = 0;
  for (const ForceErrorRow& r : rows) {
    table.row({r.packing, std::to_string(r.particles), fmt::format("{:g}", r.friction), r.precision,
               std::to_string(r.error.contacts), fmt::format("{:.2e}", r.error.median),
               fmt::format("{:.2e}", r.error.largest), std::to_string(r.error.missed),
               std::to_string(r.error.spurious)});
    const double x =
        place_in(packings, fmt::format("{}, {} spheres, μ {:g}", r.packing, r.particles, r.friction));
    const auto colour = static_cast<std::size_t>(place_in(precisions, r.precision)) - 1;
    for (const ErrorLine& line : lines) {
      Series fresh{fmt::format("{}, {}", line.name, r.precision)};
      fresh.colour = series_colours[colour % series_colours.size()];
      fresh.marker = line.marker;
      fresh.line = LineStyle::none;
      Series& s = series_named(chart, fresh);
      s.x.push_back(x);
      s.y.push_back(r.error.*line.error);
      if (line.error == &ForceError::largest && colour == 0) {
        std::string words = packings[static_cast<std::size_t>(x) - 1];
        std::replace(words.begin(), words.end(), '_', ' ');
        chart.notes.push_back({x, s.y.back(), words});
      }
    }
  }
  chart.x.high = static_cast<double>(packings.size()) + 1;
  return {table, chart};
}

}  // namespace furnas
