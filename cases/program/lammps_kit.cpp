#include "cases/program/lammps_kit.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

#include "cases/program/run/run_folder.h"
#include "engine/protocol/protocol.h"
#include "io/atomic_file.h"
#include "io/case_file.h"
#include "io/case_protocol.h"
#include "io/lammps_data.h"

namespace furnas {
namespace {

/// Columns of history.csv that LAMMPS can compute, and the formula after "equal" in the LAMMPS variable.
struct Measure {
  const char* name;
  const char* of_lammps;
};

/// Energies of LAMMPS are per particle, too (units lj), but the energy of the spins is a sum.
constexpr Measure measures[] = {{"Step", "step"},
                                {"Time", "time"},
                                {"Phi", "${spheres}/vol"},
                                {"Press", "press"},
                                {"Pxx", "pxx"},
                                {"Pyy", "pyy"},
                                {"Pzz", "pzz"},
                                {"Pxy", "pxy"},
                                {"Pxz", "pxz"},
                                {"Pyz", "pyz"},
                                {"KinEng", "ke+c_spins/atoms"},
                                {"Contacts", "c_touches/2"},
                                {"Z", "c_touches/atoms"},
                                {"Volume", "vol"},
                                {"Lx", "lx"},
                                {"Ly", "ly"},
                                {"Lz", "lz"},
                                {"Xy", "xy"},
                                {"Xz", "xz"},
                                {"Yz", "yz"}};

constexpr const char* dumped =
    "id type radius mass xu yu zu vx vy vz omegax omegay omegaz fx fy fz tqx tqy tqz";

/// Defines a variable for each column, and prints them as a table on the screen and to history.csv. LAMMPS
/// requires every quantity that a variable uses to be printed on the screen, therefore `ke`.
std::string lines_of_history() {
  std::string variables, names, values, columns;
  for (const Measure& m : measures) {
    variables += fmt::format("variable {} equal {}\n", m.name, m.of_lammps);
    names += fmt::format("{}{}", names.empty() ? "" : ",", m.name);
    values += fmt::format("{}${{{}}}", values.empty() ? "" : ",", m.name);
    const std::string_view value = m.of_lammps;
    const bool keyword = value.find_first_not_of("abcdefghijklmnopqrstuvwxyz") == value.npos;
    columns += keyword ? fmt::format(" {}", value) : fmt::format(" v_{}", m.name);
  }
  return fmt::format(R"(compute spins all erotate/sphere
compute touch all contact/atom
compute touches all reduce sum c_touch
{}thermo_style custom{} ke
thermo ${{every}}
fix history all print ${{every}} "{}" file history.csv title "{}" screen no
)",
                     variables, columns, values, names);
}

bool has_two_sizes(const Packing& packing) {
  const auto [least, most] = std::minmax_element(packing.radius.begin(), packing.radius.end());
  return *least != *most;
}

std::string deck_of(const Packing& packing, const Model& model, const std::string& source) {
  const bool two = has_two_sizes(packing);
  return fmt::format(R"(# Continues the compaction of {}; written by furnas. See README.
variable steps index 100000   # steps of this run
variable every index 1000     # steps between rows of history.csv
variable save index 10000     # steps between two writes of packing.dump
units lj
atom_style sphere
boundary p p p
newton {}
box tilt large
read_data packing.data
reset_timestep {}
neighbor {} {}
neigh_modify delay 0 every 1 check yes one 20000 page 2000000
comm_modify {}vel yes
{}
pair_coeff * *
timestep {}
{}
variable spheres equal {}
{}run ${{steps}} every ${{save}} &
  "write_dump all custom new.dump {} modify format float %.17g" &
  "shell /bin/mv new.dump packing.dump"
)",
                     source, two ? "on" : "off", packing.step, two ? 0.1 : 0.05, two ? "multi" : "bin",
                     two ? "mode multi reduce/multi " : "", lammps_law(model), model.time_step,
                     lammps_bath(packing, model), packing.sphere_volume(), lines_of_history(), dumped);
}

/// Properties of the run that LAMMPS does not have.
std::string lost(const Case& c) {
  std::string text = "the histories of the contacts, the rate of the cell";
  if (c.contact.law != "hooke_history" && c.contact.friction > 0)
    text += fmt::format(", the law {} (LAMMPS has hooke_history)", c.contact.law);
  if (!c.contact.winding && c.contact.friction > 0) text += ", springs that do not exceed Coulomb's limit";
  if (c.contact.velocity == "total") text += ", contact velocities that include the flow of the cell";
  return text +
         " and the verdict: LAMMPS takes the given number of steps, whether the packing is at rest or not";
}

std::string readme(const Packing& packing, const Case& c, const std::string& source) {
  return fmt::format(
      "{} spheres of {}, a compaction for LAMMPS to continue: mpirun -np 16 lmp -in in.furnas -var steps "
      "100000\n"
      "To come back, furnas import packing.dump describes the packing that LAMMPS wrote, and furnas run "
      "back.toml continues it to its verdict; history.csv has the columns of furnas that LAMMPS can "
      "compute.\n"
      "Lost in LAMMPS: {}.\n",
      packing.size(), source, lost(c));
}

}  // namespace

std::string lammps_law(const Model& model) {
  const HookeConstants& c = constants_of(model.law);
  const char* const attraction = c.attraction ? "" : " limit_damping";
  if (c.friction == 0)
    return fmt::format("pair_style gran/hooke/history 1.0 0.0 {} 0.0 0.0 0{}", c.normal_damping, attraction);
  return fmt::format("pair_style gran/hooke/history 1.0 {} {} {} {} 1{}", c.tangential_stiffness,
                     c.normal_damping, c.tangential_damping, c.friction, attraction);
}

/// In LAMMPS the inertia of the cell is W = (N + 1) T Pdamp^2. Twice per step, LAMMPS multiplies the rate of
/// the cell by 1 - dt drag/Pdamp.
std::string lammps_bath(const Packing& packing, const Model& model) {
  const Barostat& b = model.barostat;
  if (b.freedom == CellFreedom::fixed) return "fix 1 all nve/sphere";
  constexpr double damp = 3;
  const double temperature = b.inertia / (static_cast<double>(packing.size() + 1) * damp * damp);
  const bool tilts = b.freedom == CellFreedom::triclinic;
  const char* const freedom = tilts ? "tri" : b.freedom == CellFreedom::cubic ? "iso" : "aniso";
  return fmt::format("fix 1 all nph/sphere {0} {1} {1} {2} ptemp {3} pchain 0{4}{5}", freedom, b.pressure,
                     damp, temperature, tilts ? " flip yes" : "",
                     b.drag > 0 ? fmt::format(" drag {}", b.drag * damp / 2) : "");
}

Packing for_lammps(Packing packing) {
  packing.cell.rate = {};
  packing.order.clear();
  packing.contacts.clear();
  packing.image.assign(packing.size(), {});
  return packing;
}

void write_lammps_kit(const Packing& packing, const Case& c, std::size_t reached, const std::string& source,
                      const std::filesystem::path& folder) {
  const Protocol protocol = protocol_of(c);
  Model model = model_of(protocol, packing);
  const std::vector<Barostat> baths = baths_of(protocol, packing);
  reached = std::min(reached, baths.size() - 1);
  model.barostat = baths[reached];
  const Packing start = for_lammps(packing);
  Case back = c;
  back.start.file = "packing.dump";
  auto& pressures = back.compaction.pressure;
  pressures.erase(pressures.begin(), pressures.begin() + static_cast<std::ptrdiff_t>(reached));
  make_folder(folder);
  write_lammps_data(start, folder / "packing.data");
  write_file(folder / "in.furnas", deck_of(start, model, source));
  write_file(folder / "back.toml", resolved_toml(back));
  write_file(folder / "README", readme(start, c, source));
}

}  // namespace furnas
