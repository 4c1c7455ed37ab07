#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "io/formats.h"
#include "tests/cases/runs.h"

namespace furnas {
namespace {

/// Debian's own Python, which has Debian's ASE.
constexpr const char* python = "/usr/bin/python3";

bool succeeds(const std::string& command) { return std::system((command + " >/dev/null 2>&1").c_str()) == 0; }

/// A jammed-looking packing of two sizes with all that a file can say, its tilts as LAMMPS takes them.
Packing packing_for_others() {
  Packing p = random_packing(11);
  p.velocity[1] = {};
  p.contacts.clear();
  return p;
}

/// ASE reads what furnas writes, and furnas what ASE writes of it, to the eight digits that ASE writes.
TEST(NightlyOtherPrograms, AseReadsAndWritesOurExtendedXyz) {
  if (!succeeds(std::string(python) + " -c 'import ase'"))
    GTEST_SKIP() << "python3-ase is not installed; on Debian: apt-get install python3-ase";
  const Runs runs;
  const Packing p = packing_for_others();
  write_packing(p, "extxyz", runs.path("a.extxyz"));
  write_file(runs.path("a.py"), fmt::format(R"(
import numpy
from ase.io import read, write
atoms = read('{0}')
assert len(atoms) == {1}, len(atoms)
assert atoms.pbc.all()
assert atoms.get_chemical_symbols()[:3] == ['Au', 'Au', 'Ag'], atoms.get_chemical_symbols()
assert list(atoms.arrays['species_name'][:3]) == ['small', 'small', 'large']
assert abs(atoms.get_volume() / {2} - 1) < 1e-7
assert abs(atoms.arrays['mass'][0] / {3} - 1) < 1e-7
assert atoms.info['Step'] == {4}
write('{5}', [atoms, atoms], format='extxyz')
)",
                                            runs.path("a.extxyz"), p.size(), p.cell.volume(), p.mass[0],
                                            p.step, runs.path("b.extxyz")));
  ASSERT_EQ(std::system(fmt::format("{} {}", python, runs.path("a.py")).c_str()), 0);
  const Packing back = read_packing(runs.path("b.extxyz"));
  EXPECT_EQ(back.species, p.species);
  for (std::size_t k = 0; k < p.size(); ++k) {
    EXPECT_NEAR(back.radius[k], p.radius[k], 1e-8);
    EXPECT_NEAR(back.mass[k], p.mass[k], 1e-8);
    EXPECT_LT(norm(back.unwrapped(k) - p.unwrapped(k)), 1e-6);
  }
}

/// LAMMPS reads what furnas writes, and furnas the data file and the dump that LAMMPS makes of it.
TEST(NightlyOtherPrograms, LammpsReadsAndWritesOurFiles) {
  if (!succeeds("command -v lmp"))
    GTEST_SKIP() << "lmp is not on the PATH; on Debian: apt-get install lammps";
  const Runs runs;
  Packing p = packing_for_others();
  p.cell.edges.xy = 0.53 * p.cell.edges.xx;  // which LAMMPS would refuse as it is
  p.labels.origin = {1, -2, 3};
  for (std::size_t k = 0; k < p.size(); ++k) p.labels.id.push_back(3 * static_cast<std::int64_t>(k) + 2);
  write_packing(p, "lammps-data", runs.path("a.data"));
  write_packing(p, "lammps-dump", runs.path("a.dump"));
  write_file(runs.path("in"), fmt::format(R"(units lj
atom_style sphere
boundary p p p
read_data {0}
write_data {1}
write_dump all custom {2} id type radius mass x y z ix iy iz vx vy vz omegax omegay omegaz modify sort id format float %.16g
read_dump {3} {4} x y z vx vy vz box yes wrapped no format native
)",
                                          runs.path("a.data"), runs.path("b.data"), runs.path("b.dump"),
                                          runs.path("a.dump"), p.step));
  ASSERT_EQ(
      std::system(fmt::format("lmp -log none -in {0} >{1} 2>&1", runs.path("in"), runs.path("said")).c_str()),
      0)
      << content(runs.path("said"));
  for (const char* file : {"b.data", "b.dump"}) {
    const Packing q = read_packing(runs.path(file));
    EXPECT_EQ(q.labels.id, p.labels.id) << file;
    EXPECT_EQ(q.species, p.species) << file;
    for (std::size_t k = 0; k < p.size(); ++k) {
      EXPECT_NEAR(q.mass[k] / p.mass[k], 1, 1e-13) << file;
      EXPECT_NEAR(q.radius[k], p.radius[k], 1e-13) << file;
      EXPECT_LT(norm(q.unwrapped(k) - p.unwrapped(k)), 1e-9) << file << ' ' << k;
      EXPECT_LT(norm(q.velocity[k] - p.velocity[k]), 1e-15) << file;
    }
  }
}

}  // namespace
}  // namespace furnas
