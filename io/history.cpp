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
  OutputField about;
  double (*value)(const Measures&);
};

double per_particle(double energy, const Measures& m) { return energy / static_cast<double>(m.particles); }

/// The columns in order; the names are those of LAMMPS where LAMMPS has one.
constexpr Column columns[] = {
    {{"Step", "", "run", "time step"}, [](const Measures& m) { return static_cast<double>(m.step); }},
    {{"Time", "(rho d_s^3/k_n)^(1/2)", "run", "simulated time"}, [](const Measures& m) { return m.time; }},
    {{"Phi", "", "packing", "packing fraction"}, [](const Measures& m) { return m.phi; }},
    {{"Press", "k_n/d_s", "packing", "trace(P)/3 of the measured stress, positive in compression"},
     [](const Measures& m) { return m.pressure; }},
    {{"Pxx", "k_n/d_s", "packing", "P = (sum m v v + sum branch force)/volume, positive in compression"},
     [](const Measures& m) { return m.stress[0]; }},
    {{"Pyy", "k_n/d_s", "packing", "the same"}, [](const Measures& m) { return m.stress[1]; }},
    {{"Pzz", "k_n/d_s", "packing", "the same"}, [](const Measures& m) { return m.stress[2]; }},
    {{"Pxy", "k_n/d_s", "packing", "the same"}, [](const Measures& m) { return m.stress[3]; }},
    {{"Pxz", "k_n/d_s", "packing", "the same"}, [](const Measures& m) { return m.stress[4]; }},
    {{"Pyz", "k_n/d_s", "packing", "the same"}, [](const Measures& m) { return m.stress[5]; }},
    {{"KinEng", "k_n d_s^2", "per particle",
      "kinetic energy of the peculiar motion and spin, rattlers included"},
     [](const Measures& m) { return m.kinetic_energy; }},
    {{"KinEngBackbone", "k_n d_s^2", "per backbone particle", "the same for the backbone"},
     [](const Measures& m) { return m.backbone_kinetic_energy; }},
    {{"ForceImbalance", "", "mean over the backbone",
      "size of the net force on a particle over the mean force of a contact"},
     [](const Measures& m) { return m.force_imbalance; }},
    {{"Contacts", "", "total", "pairs that overlap, live or not"},
     [](const Measures& m) { return static_cast<double>(m.contacts); }},
    {{"Z", "", "per particle", "coordination: 2 contacts/particles, rattlers included"},
     [](const Measures& m) { return m.coordination; }},
    {{"Backbone", "", "total", "spheres that are no rattlers, by the threshold of the run"},
     [](const Measures& m) { return static_cast<double>(m.backbone().backbone); }},
    {{"SlidingShare", "", "share of the contacts", "those at the Coulomb limit"},
     [](const Measures& m) { return m.sliding_share; }},
    {{"MaxOverlap", "", "largest of the contacts", "overlap over the smaller radius of the pair"},
     [](const Measures& m) { return m.largest_overlap; }},
    {{"Volume", "d_s^3", "cell", "of the cell"}, [](const Measures& m) { return m.cell.volume(); }},
    {{"Lx", "d_s", "cell", "edges of the cell are (Lx, 0, 0), (Xy, Ly, 0), (Xz, Yz, Lz)"},
     [](const Measures& m) { return m.cell.edges.xx; }},
    {{"Ly", "d_s", "cell", "the same"}, [](const Measures& m) { return m.cell.edges.yy; }},
    {{"Lz", "d_s", "cell", "the same"}, [](const Measures& m) { return m.cell.edges.zz; }},
    {{"Xy", "d_s", "cell", "the same"}, [](const Measures& m) { return m.cell.edges.xy; }},
    {{"Xz", "d_s", "cell", "the same"}, [](const Measures& m) { return m.cell.edges.xz; }},
    {{"Yz", "d_s", "cell", "the same"}, [](const Measures& m) { return m.cell.edges.yz; }},
    {{"NormalEnergy", "k_n d_s^2", "per particle", "stored in overlaps"},
     [](const Measures& m) { return per_particle(m.energy.normal, m); }},
    {{"TangentialEnergy", "k_n d_s^2", "per particle", "stored in tangential springs"},
     [](const Measures& m) { return per_particle(m.energy.tangential, m); }},
    {{"CellWork", "k_n d_s^2", "per particle, since the start",
      "done by the moving cell on the particles, positive when it compresses them"},
     [](const Measures& m) { return per_particle(m.ledger.cell_work, m); }},
    {{"NormalDamping", "k_n d_s^2", "per particle, since the start", "taken out by normal damping"},
     [](const Measures& m) { return per_particle(m.ledger.losses.normal_damping, m); }},
    {{"TangentialDamping", "k_n d_s^2", "per particle, since the start", "taken out by tangential damping"},
     [](const Measures& m) { return per_particle(m.ledger.losses.tangential_damping, m); }},
    {{"Sliding", "k_n d_s^2", "per particle, since the start", "taken out by contacts at the Coulomb limit"},
     [](const Measures& m) { return per_particle(m.ledger.losses.sliding, m); }},
    {{"Opening", "k_n d_s^2", "per particle, since the start",
      "left in the tangential springs of contacts that opened"},
     [](const Measures& m) { return per_particle(m.ledger.losses.opening, m); }},
    {{"Quenched", "k_n d_s^2", "per particle, since the start",
      "kinetic energy removed when all motion is set to zero, and energy removed by the minimizer"},
     [](const Measures& m) { return per_particle(m.ledger.quenched, m); }},
    {{"EnergyGap", "k_n d_s^2", "per particle",
      "energy of the packing minus the energy that the balance accounts for; 0 if nothing is missing"},
     [](const Measures& m) { return per_particle(m.ledger.gap(m.energy.total()), m); }},
};

}  // namespace

std::vector<std::string> history_columns() {
  std::vector<std::string> names;
  for (const Column& column : columns) names.emplace_back(column.about.name);
  return names;
}

std::vector<OutputField> history_fields() {
  std::vector<OutputField> fields;
  for (const Column& column : columns) fields.push_back(column.about);
  return fields;
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
  if (!read_csv_row(file, cells, path.string()))
    throw InputError(path.string() + " cannot be read; allowed: a history.csv");
  std::vector<std::size_t> places;
  for (const std::string& column : wanted) {
    const auto found = std::find(cells.begin(), cells.end(), column);
    if (found == cells.end())
      throw InputError(fmt::format("{}: there is no column {}", path.string(), column));
    places.push_back(static_cast<std::size_t>(found - cells.begin()));
  }
  const std::size_t width = cells.size();
  std::vector<std::vector<double>> values(wanted.size());
  while (read_csv_row(file, cells, path.string())) {
    if (cells.size() != width) throw InputError(path.string() + ": a row is not complete");
    for (std::size_t k = 0; k < places.size(); ++k)
      values[k].push_back(number_in<double>(cells[places[k]]).value_or(std::nan("")));
  }
  return values;
}

}  // namespace furnas
