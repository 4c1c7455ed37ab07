#include <fmt/format.h>

#include <cmath>

#include "cases/program/sweep/finite_size.h"
#include "cases/program/sweep/points.h"
#include "cases/program/table.h"

namespace furnas {
namespace {

using Mean = const std::optional<MeanInterval>&;

std::string number(double value) { return std::isfinite(value) ? fmt::format("{:.6g}", value) : ""; }

const PointColumn point_column_table[] = {
    {{"large", "", "sample", "large spheres"}, [](const Point& p) { return std::to_string(p.large); }},
    {{"small", "", "sample", "small spheres"}, [](const Point& p) { return std::to_string(p.small); }},
    {{"samples", "", "total", "samples of this point"},
     [](const Point& p) { return std::to_string(p.samples); }},
    {{"jammed", "", "total", "those of them that jammed"},
     [](const Point& p) { return std::to_string(p.jammed); }},
    {{"settled", "", "total",
      "those that settled: not at rest, but with a bound on the further change of phi"},
     [](const Point& p) { return std::to_string(p.settled); }},
    {{"jammed_share", "", "share of the samples", "jammed/samples"},
     [](const Point& p) {
       return fmt::format("{:.3g}", static_cast<double>(p.jammed) / static_cast<double>(p.samples));
     }},
    {{"budget", "", "total", "samples that spent their steps or time before the packing came to rest"},
     [](const Point& p) { return std::to_string(p.budget); }},
    {{"diverged", "", "total", "samples that diverged: a check of the state failed and ended the run"},
     [](const Point& p) { return std::to_string(p.diverged); }},
    {{"failed", "", "total", "samples that were refused or crashed"},
     [](const Point& p) { return std::to_string(p.failed); }},
    {{"unfinished", "", "total", "samples that have not come to their end"},
     [](const Point& p) { return std::to_string(p.unfinished); }},
    {{"effective_size", "", "total",
      "backbone spheres of all jammed and settled samples together; where the small spheres rattle only the "
      "large ones count"},
     [](const Point& p) { return fmt::format("{:.0f}", p.effective_size); }},
    {{"phi_J", "", "mean of the samples", "packing fraction; of a settled sample phi stands for phi_J"},
     nullptr,
     [](const Point& p) -> Mean { return p.mean_phi_J; },
     "φ_J"},
    {{"Z_backbone", "", "mean of the samples", "coordination of the backbone, per backbone particle"},
     nullptr,
     [](const Point& p) -> Mean { return p.mean_Z_backbone; },
     "Z of the backbone"},
    {{"large_rattlers_2", "", "mean of the samples",
      "share of the large spheres that are rattlers when a sphere needs 2 live contacts"},
     nullptr,
     [](const Point& p) -> Mean { return p.large_rattlers[0]; },
     "share of rattlers among the large spheres"},
    {{"large_rattlers_3", "", "mean of the samples", "the same with 3"},
     nullptr,
     [](const Point& p) -> Mean { return p.large_rattlers[1]; },
     "share of rattlers among the large spheres"},
    {{"large_rattlers_4", "", "mean of the samples", "the same with 4"},
     nullptr,
     [](const Point& p) -> Mean { return p.large_rattlers[2]; },
     "share of rattlers among the large spheres"},
    {{"small_rattlers_2", "", "mean of the samples",
      "share of the small spheres that are rattlers when a sphere needs 2 live contacts"},
     nullptr,
     [](const Point& p) -> Mean { return p.small_rattlers[0]; },
     "share of rattlers among the small spheres"},
    {{"small_rattlers_3", "", "mean of the samples", "the same with 3"},
     nullptr,
     [](const Point& p) -> Mean { return p.small_rattlers[1]; },
     "share of rattlers among the small spheres"},
    {{"small_rattlers_4", "", "mean of the samples", "the same with 4"},
     nullptr,
     [](const Point& p) -> Mean { return p.small_rattlers[2]; },
     "share of rattlers among the small spheres"},
    {{"thickness", "", "least of the samples",
      "least distance between opposite faces of a cell, in diameters of the largest sphere; below 2.5 "
      "the cell is too thin to represent a large packing; empty if not known"},
     [](const Point& p) { return std::isfinite(p.thickness) ? fmt::format("{:.3g}", p.thickness) : ""; }},
    {{"finite_size", "", "sample",
      "phi_J of a large packing minus this phi_J, as far as the number of spheres alone causes the "
      "difference, +- its uncertainty; unknown where it has not been measured; empty without phi_J"},
     finite_size_text},
    {{"pressure", "k_n/d_s", "sample", "of the bath, p_a"},
     [](const Point& p) { return number(p.pressure); }},
    {{"preset", "", "sample", "the preset of the case"}, [](const Point& p) { return p.preset; }},
};

}  // namespace

std::string thickness_text(const Point& p) {
  if (!std::isfinite(p.thickness_at_most)) return "-";
  return fmt::format("{}{:.1f}", std::isfinite(p.thickness) ? "" : "at most ", p.thickness_at_most);
}

std::span<const PointColumn> point_columns() { return point_column_table; }

std::string name_of_half_width(const PointColumn& column) {
  return fmt::format("{}_half_width", column.about.name);
}

std::string csv(const std::vector<Point>& points, const std::vector<std::string>& keys) {
  std::vector<std::string> names = keys;
  for (const PointColumn& column : point_column_table) {
    names.emplace_back(column.about.name);
    if (column.mean != nullptr) names.push_back(name_of_half_width(column));
  }
  Table text(names);
  for (const Point& p : points) {
    std::vector<std::string> cells = p.values;
    for (const PointColumn& column : point_column_table) {
      if (column.mean == nullptr) {
        cells.push_back(column.cell(p));
        continue;
      }
      const std::optional<MeanInterval>& mean = column.mean(p);
      cells.push_back(mean ? number(mean->mean) : "");
      cells.push_back(mean ? number(mean->half_width) : "");
    }
    text.row(cells);
  }
  return text.csv();
}

}  // namespace furnas
