#include "cases/program/bench/lammps.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "cases/program/lammps_kit.h"
#include "cases/program/shell_word.h"
#include "engine/base/require.h"
#include "io/atomic_file.h"
#include "io/lammps_data.h"
#include "io/lammps_dump.h"

namespace furnas {
namespace {

namespace fs = std::filesystem;

void require_on_path(const std::string& program) {
  const char* const path = std::getenv("PATH");
  std::istringstream folders(path ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');)
    if (::access((fs::path(folder) / program).c_str(), X_OK) == 0) return;
  throw InputError(program + " is not on the PATH; on Debian: apt-get install lammps openmpi-bin");
}

}  // namespace

std::string lammps_deck(const Packing& packing, const Model& model) {
  return fmt::format(R"(# Written by furnas bench peers.
units lj
atom_style sphere
boundary p p p
newton ${{newton}}
box tilt large
read_data packing.data
neighbor ${{skin}} ${{style}}
neigh_modify delay 0 every 1 check yes one 20000 page 2000000
if "${{style}} == multi" then "comm_modify mode multi vel yes reduce/multi" else "comm_modify vel yes"
{}
pair_coeff * *
timestep {}
{}
thermo_style custom step cpu vol press ke
thermo ${{steps}}
if "${{dump}} == yes" then "dump 1 all custom 1 forces.dump id type radius xu yu zu fx fy fz" &
  "dump_modify 1 format float %.17g"
run ${{steps}}
)",
                     lammps_law(model), model.time_step, lammps_bath(packing, model));
}

namespace {

/// Throws LAMMPS's own error message if its log has one.
void refuse_error_in(const fs::path& log) {
  std::ifstream file(log);
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("ERROR")) throw std::runtime_error("LAMMPS: " + line);
}

}  // namespace

LammpsTiming timing_in(const fs::path& log) {
  refuse_error_in(log);
  std::ifstream file(log);
  LammpsTiming timing;
  bool timed = false;
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string word;
    if (line.starts_with("Loop time of "))
      timed = static_cast<bool>(words >> word >> word >> word >> timing.seconds);
    if (line.starts_with("Neighbor list builds = ")) words >> word >> word >> word >> word >> timing.rebuilds;
  }
  if (!timed) throw std::runtime_error("LAMMPS: no timing in " + log.string());
  return timing;
}

Lammps::Lammps(fs::path folder, const Packing& packing, const Model& model, int ranks)
    : folder_(std::move(folder)), ranks_(ranks) {
  require_on_path("lmp");
  if (ranks > 1) require_on_path("mpirun");
  write_lammps_data(packing, folder_ / "packing.data");
  write_file(folder_ / "in.furnas", lammps_deck(packing, model));
}

void Lammps::call(const LammpsSetting& setting, std::int64_t steps, int ranks, Dump dump) const {
  // OpenMPI refuses to run as root, as in a container, unless two variables are set.
  ::setenv("OMPI_ALLOW_RUN_AS_ROOT", "1", 1);
  ::setenv("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1", 1);
  fs::remove(folder_ / "log.lammps");
  const std::string command = fmt::format(
      "cd {} && {}lmp -in in.furnas -log log.lammps -var style {} -var newton {} -var skin {} -var steps {} "
      "-var dump {} >screen.txt 2>&1",
      shell_word(folder_.string()), ranks > 1 ? fmt::format("mpirun -np {} ", ranks) : "", setting.style,
      setting.style == "multi" ? "on" : "off", setting.skin, steps, dump == Dump::forces ? "yes" : "no");
  if (std::system(command.c_str()) == 0) return;
  refuse_error_in(folder_ / "log.lammps");
  throw std::runtime_error("LAMMPS failed; its last messages are in " + (folder_ / "screen.txt").string());
}

LammpsTiming Lammps::run(const LammpsSetting& setting, std::int64_t steps) const {
  call(setting, steps, ranks_, Dump::no);
  return timing_in(folder_ / "log.lammps");
}

Packing Lammps::forces() const {
  call({}, 0, 1, Dump::forces);
  return read_lammps_frame(folder_ / "forces.dump");
}

}  // namespace furnas
