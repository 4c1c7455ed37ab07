#include "cases/program/sweep/sample_columns.h"

#include <fmt/format.h>

#include <cmath>

#include "io/csv.h"

namespace furnas {
namespace {

using Value = SampleColumn::Value;

const SampleColumn sample_column_table[] = {
    {{"seed", "", "sample", "mixture.seed, which chooses the random start"},
     "seed",
     [](SampleRow& r) -> Value { return &r.seed; }},
    {{"large", "", "total", "large spheres; empty in a polydisperse packing, and when there is no result"},
     "N_l",
     [](SampleRow& r) -> Value { return &r.large; }},
    {{"small", "", "total", "small spheres; empty in a polydisperse packing, and when there is no result"},
     "N_s",
     [](SampleRow& r) -> Value { return &r.small; }},
    {{"verdict", "", "sample",
      "jammed, settled, budget or diverged as in result.json; failed: refused or crashed; unfinished: it has "
      "not come to its end"},
     "",
     [](SampleRow& r) -> Value { return &r.verdict; }},
    {{"reason", "", "sample", "reason of the verdict, in a sentence; ';' stands for ','"},
     "",
     [](SampleRow& r) -> Value { return &r.reason; }},
    {{"phi_J", "", "sample", "packing fraction at jamming; empty unless jammed"},
     "φ_J",
     [](SampleRow& r) -> Value { return &r.phi_J; }},
    {{"phi", "", "sample", "packing fraction at the end, whatever the verdict"},
     "φ",
     [](SampleRow& r) -> Value { return &r.phi; }},
    {{"Z", "", "per particle", "coordination: 2 contacts/particles, rattlers included"},
     "Z",
     [](SampleRow& r) -> Value { return &r.Z; }},
    {{"Z_backbone", "", "per backbone particle", "the same for the backbone alone"},
     "Z of the backbone",
     [](SampleRow& r) -> Value { return &r.Z_backbone; }},
    {{"backbone", "", "total", "spheres that are no rattlers, by the threshold of the run"},
     "spheres of the backbone",
     [](SampleRow& r) -> Value { return &r.backbone; }},
    {{"large_rattlers_2", "", "total", "large spheres that are rattlers when a sphere needs 2 live contacts"},
     "large rattlers (fewer than 2 contacts)",
     [](SampleRow& r) -> Value { return &r.large_rattlers[0]; }},
    {{"large_rattlers_3", "", "total", "the same with 3"},
     "large rattlers (fewer than 3 contacts)",
     [](SampleRow& r) -> Value { return &r.large_rattlers[1]; }},
    {{"large_rattlers_4", "", "total", "the same with 4"},
     "large rattlers (fewer than 4 contacts)",
     [](SampleRow& r) -> Value { return &r.large_rattlers[2]; }},
    {{"small_rattlers_2", "", "total", "small spheres that are rattlers when a sphere needs 2 live contacts"},
     "small rattlers (fewer than 2 contacts)",
     [](SampleRow& r) -> Value { return &r.small_rattlers[0]; }},
    {{"small_rattlers_3", "", "total", "the same with 3"},
     "small rattlers (fewer than 3 contacts)",
     [](SampleRow& r) -> Value { return &r.small_rattlers[1]; }},
    {{"small_rattlers_4", "", "total", "the same with 4"},
     "small rattlers (fewer than 4 contacts)",
     [](SampleRow& r) -> Value { return &r.small_rattlers[2]; }},
    {{"steps", "", "total", "time steps taken"}, "steps", [](SampleRow& r) -> Value { return &r.steps; }},
    {{"wall_seconds", "s", "total", "wall-clock time of all processes of the run"},
     "wall-clock time / s",
     [](SampleRow& r) -> Value { return &r.wall_seconds; }},
    {{"state_hash", "", "sample",
      "checksum of the whole packing; packings with equal bits have equal hashes"},
     "",
     [](SampleRow& r) -> Value { return &r.state_hash; }},
    {{"phi_bound", "", "sample", "of a settled sample: bound on the further change of phi; otherwise empty"},
     "bound on φ",
     [](SampleRow& r) -> Value { return &r.phi_bound; }},
    {{"thickness", "", "sample",
      "least distance between opposite faces of the cell, in diameters of the largest sphere; below 2.5 the "
      "cell is too thin to represent a large packing; empty in tables of older versions"},
     "thickness of the cell in largest diameters",
     [](SampleRow& r) -> Value { return &r.thickness; }},
    {{"pressure", "k_n/d_s", "sample", "of the bath, p_a, the last of compaction.pressure"},
     "p_a / (k_n/d_s)",
     [](SampleRow& r) -> Value { return &r.pressure; }},
    {{"preset", "", "sample", "the preset of the case"}, "", [](SampleRow& r) -> Value { return &r.preset; }},
};

/// Whether a column counts spheres of a species, which a polydisperse packing and a sample without a result
/// do not have.
bool counts_a_species(const SampleColumn& column) {
  const std::string_view name = column.about.name;
  return name.starts_with("large") || name.starts_with("small");
}

}  // namespace

std::span<const SampleColumn> sample_columns() { return sample_column_table; }

std::string cell_of(const SampleColumn& column, const SampleRow& row) {
  if (counts_a_species(column) && row.large + row.small == 0) return "";
  // A column gives access to its value for reading and for writing; the copy protects `row`.
  SampleRow copy = row;
  const Value value = column.value(copy);
  if (auto* const* words = std::get_if<std::string*>(&value)) return without_commas(**words);
  if (auto* const* count = std::get_if<std::int64_t*>(&value)) return std::to_string(**count);
  const double number = *std::get<double*>(value);
  return std::isfinite(number) ? fmt::format("{}", number) : "";
}

std::optional<double> number_of(const SampleColumn& column, const SampleRow& row) {
  if (counts_a_species(column) && row.large + row.small == 0) return {};
  SampleRow copy = row;
  const Value value = column.value(copy);
  if (auto* const* count = std::get_if<std::int64_t*>(&value)) return static_cast<double>(**count);
  if (auto* const* number = std::get_if<double*>(&value); number != nullptr && std::isfinite(**number))
    return **number;
  return {};
}

}  // namespace furnas
