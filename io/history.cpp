#include "io/history.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/base/numbers.h"
#include "engine/base/require.h"
#include "io/csv.h"
#include "io/text_reader.h"

namespace furnas {
namespace {

struct Column {
  const char* name;
  double (*value)(const Measures&);
};

double per_particle(double energy, const Measures& m) { return energy / static_cast<double>(m.particles); }

/// The columns in order; names are those of LAMMPS where it has one. Energies are per particle.
constexpr Column columns[] = {
    {"Step", [](const Measures& m) { return static_cast<double>(m.step); }},
    {"Time", [](const Measures& m) { return m.time; }},
    {"Phi", [](const Measures& m) { return m.phi; }},
    {"Press", [](const Measures& m) { return m.pressure; }},
    {"Pxx", [](const Measures& m) { return m.stress[0]; }},
    {"Pyy", [](const Measures& m) { return m.stress[1]; }},
    {"Pzz", [](const Measures& m) { return m.stress[2]; }},
    {"Pxy", [](const Measures& m) { return m.stress[3]; }},
    {"Pxz", [](const Measures& m) { return m.stress[4]; }},
    {"Pyz", [](const Measures& m) { return m.stress[5]; }},
    {"KinEng", [](const Measures& m) { return m.kinetic_energy; }},
    {"KinEngBackbone", [](const Measures& m) { return m.backbone_kinetic_energy; }},
    {"ForceImbalance", [](const Measures& m) { return m.force_imbalance; }},
    {"Contacts", [](const Measures& m) { return static_cast<double>(m.contacts); }},
    {"Z", [](const Measures& m) { return m.coordination; }},
    {"Backbone", [](const Measures& m) { return static_cast<double>(m.backbone().backbone); }},
    {"SlidingShare", [](const Measures& m) { return m.sliding_share; }},
    {"MaxOverlap", [](const Measures& m) { return m.largest_overlap; }},
    {"Volume", [](const Measures& m) { return m.cell.volume(); }},
    {"Lx", [](const Measures& m) { return m.cell.edges.xx; }},
    {"Ly", [](const Measures& m) { return m.cell.edges.yy; }},
    {"Lz", [](const Measures& m) { return m.cell.edges.zz; }},
    {"Xy", [](const Measures& m) { return m.cell.edges.xy; }},
    {"Xz", [](const Measures& m) { return m.cell.edges.xz; }},
    {"Yz", [](const Measures& m) { return m.cell.edges.yz; }},
    {"NormalEnergy", [](const Measures& m) { return per_particle(m.energy.normal, m); }},
    {"TangentialEnergy", [](const Measures& m) { return per_particle(m.energy.tangential, m); }},
    {"CellWork", [](const Measures& m) { return per_particle(m.ledger.cell_work, m); }},
    {"NormalDamping", [](const Measures& m) { return per_particle(m.ledger.losses.normal_damping, m); }},
    {"TangentialDamping",
     [](const Measures& m) { return per_particle(m.ledger.losses.tangential_damping, m); }},
    {"Sliding", [](const Measures& m) { return per_particle(m.ledger.losses.sliding, m); }},
    {"Opening", [](const Measures& m) { return per_particle(m.ledger.losses.opening, m); }},
    {"Quenched", [](const Measures& m) { return per_particle(m.ledger.quenched, m); }},
    {"EnergyGap", [](const Measures& m) { return per_particle(m.ledger.gap(m.energy.total()), m); }},
};

}  // namespace

std::vector<std::string> history_columns() {
  std::vector<std::string> names;
  for (const Column& column : columns) names.emplace_back(column.name);
  return names;
}

History::History(const std::filesystem::path& path) : file_(path) {
  file_.append(csv_row(history_columns()));
}

void History::add(const Measures& m) {
  std::vector<std::string> row;
  for (const Column& column : columns) row.push_back(fmt::format("{}", column.value(m)));
  file_.append(csv_row(row));
}

std::vector<std::vector<double>> read_history(const std::filesystem::path& path,
                                              const std::vector<std::string>& wanted) {
  std::ifstream file = open_file(path);
  std::vector<std::string> cells;
  if (!read_csv_row(file, cells)) throw InputError(path.string() + " cannot be read; allowed: a history.csv");
  std::vector<std::size_t> places;
  for (const std::string& column : wanted) {
    const auto found = std::find(cells.begin(), cells.end(), column);
    if (found == cells.end())
      throw InputError(fmt::format("{}: there is no column {}", path.string(), column));
    places.push_back(static_cast<std::size_t>(found - cells.begin()));
  }
  const std::size_t width = cells.size();
  std::vector<std::vector<double>> values(wanted.size());
  while (read_csv_row(file, cells)) {
    if (cells.size() != width) throw InputError(path.string() + ": a row is not complete");
    for (std::size_t k = 0; k < places.size(); ++k)
      values[k].push_back(number_in<double>(cells[places[k]]).value_or(std::nan("")));
  }
  return values;
}

}  // namespace furnas
