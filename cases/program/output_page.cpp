#include "cases/program/output_page.h"

#include <fmt/format.h>

#include <string_view>

#include "cases/program/sweep/maxima.h"
#include "cases/program/sweep/points.h"
#include "cases/program/sweep/sample_columns.h"
#include "io/analysis_files.h"
#include "io/history.h"
#include "io/packing_fields.h"
#include "io/result_fields.h"

namespace furnas {
namespace {

constexpr std::string_view introduction = R"(# What the files hold

This page lists every field of `result.json`, every column of the tables and every array of the files of a packing. Lengths are in d_s (diameter of a small
sphere), masses in rho d_s^3, forces in k_n d_s, so time is in (rho d_s^3/k_n)^(1/2), stress in k_n/d_s and energy in k_n d_s^2; an empty unit is
a pure number or a word. "Of what" names what a number is counted over: *total* of the whole packing or sample, *per particle*, a *share*.
A half width is half of a 95 % interval (Student's t): the mean lies within +- that. An empty cell, or null, is a value that is not known.

This page is written by `furnas schema --outputs`, from the tables that write the files.
)";

class Page {
 public:
  void section(std::string_view file, std::string_view about) {
    text_ += fmt::format("\n## {}\n\n{}\n\n| {} | unit | of what | meaning |\n|---|---|---|---|\n", file,
                         about, file.ends_with(".csv") ? "column" : "field");
  }
  void row(std::string_view name, const OutputField& field) {
    text_ += fmt::format("| `{}` | {} | {} | {} |\n", name, in_cell(field.unit), in_cell(field.of),
                         in_cell(field.doc));
  }
  void row(const OutputField& field) { row(field.name, field); }
  const std::string& text() const { return text_; }

 private:
  /// Escapes "|", which would end the cell of the table.
  static std::string in_cell(std::string_view text) {
    std::string cell;
    for (const char c : text) cell += c == '|' ? std::string("\\|") : std::string(1, c);
    return cell;
  }

  std::string text_{introduction};
};

void add_run(Page& page) {
  page.section(
      "result.json",
      "The result of a run. A name with a dot is a field within an object: `stress.xx` is `xx` in `stress`.");
  for (const ResultField& field : result_fields()) {
    page.row(field.about);
    const std::string list(field.about.name);
    if (list == "rattlers")
      for (const RattlerField& entry : rattler_fields())
        page.row(fmt::format("{}[].{}", list, entry.about.name), entry.about);
    if (list == "resting_states")
      for (const RestingField& entry : resting_fields())
        page.row(fmt::format("{}[].{}", list, entry.about.name), entry.about);
  }
  page.section("history.csv",
               "A row every `output.history_every` steps; the names of columns are those of LAMMPS where "
               "LAMMPS has one.");
  for (const OutputField& field : history_fields()) page.row(field);
}

void add_packing(Page& page) {
  page.section("packing.vtp",
               "The spheres, for ParaView; each is a point at its centre [d_s], within the cell.");
  const auto place = [](const VtpField& field) {
    return fmt::format("{}: {}",
                       field.place == VtpField::Place::field   ? "FieldData"
                       : field.place == VtpField::Place::point ? "PointData"
                                                               : "CellData",
                       field.about.name);
  };
  for (const VtpField& field : packing_vtp_fields()) page.row(place(field), field.about);
  page.section(
      "contacts.vtp",
      "The contacts, for ParaView; each is a line from the centre of i to the centre of the image of j that "
      "i touches "
      "[d_s], which may lie outside the cell. `cell.vtp` has the twelve edges of the cell and no arrays.");
  for (const VtpField& field : contacts_vtp_fields()) page.row(place(field), field.about);
  page.section(
      "packing.extxyz",
      "The spheres, for OVITO and scripts. The second line has `Lattice` (the edges of the cell, one "
      "after the other) [d_s], `Origin` (its corner), `Step` and `Time`; where the start file numbers its "
      "types, `species_type` follows `species_name`.");
  for (const OutputField& field : extended_xyz_fields()) page.row(field);
  page.section("packing.csv", "The spheres as `furnas export FOLDER csv` writes them.");
  for (const OutputField& field : packing_csv_fields()) page.row(field);
  page.section("contacts.csv", "The contacts as `furnas export FOLDER contacts` writes them.");
  for (const OutputField& field : contacts_csv_fields()) page.row(field);
}

void add_analysis(Page& page) {
  for (const AnalysisFile& file : analysis_files()) {
    if (file.columns.empty()) continue;
    page.section(file.name, fmt::format("{} Written by `furnas analyze`, which also writes the numbers of "
                                        "the whole packing to `analysis.json`.",
                                        file.about));
    for (const OutputField& field : file.columns) page.row(field);
  }
}

void add_sweep(Page& page) {
  constexpr std::string_view keys = "The first columns are the keys that tell the points apart.";
  page.section("sweep.csv", fmt::format("A row for each sample of a sweep. {}", keys));
  for (const SampleColumn& column : sample_columns()) page.row(column.about);
  page.section("points.csv",
               fmt::format("A row for each point of a sweep: means of its jammed and settled samples. {} "
                           "Rattlers are shares here, but numbers in `sweep.csv`.",
                           keys));
  for (const PointColumn& column : point_columns()) {
    page.row(column.about);
    if (column.mean != nullptr)
      page.row(name_of_half_width(column),
               {"", column.about.unit, "mean of the samples",
                column.about.name == "phi_J" ? "half of its 95 % interval, plus the mean of the bounds of "
                                               "settled samples; empty for a single sample"
                                             : "half of its 95 % interval; empty for a single sample"});
  }
}

void add_maxima(Page& page) {
  page.section(
      "maxima.csv",
      "A row for each curve phi_J(f_s) of three points or more. The first columns are the other keys.");
  for (const MaximumColumn& column : maximum_columns()) page.row(column.about);
}

}  // namespace

std::string output_page() {
  Page page;
  add_run(page);
  add_packing(page);
  add_analysis(page);
  add_sweep(page);
  add_maxima(page);
  return page.text();
}

}  // namespace furnas
