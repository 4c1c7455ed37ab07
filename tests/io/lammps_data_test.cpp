#include "io/lammps_data.h"

#include "tests/io/packings.h"

namespace furnas {
namespace {

const std::string valid_data =
    "two particles\n"
    "\n"
    "2 atoms  # so many\n"
    "2 atom types\n"
    "0 bonds\n"
    "1 5 xlo xhi\n"
    "-1 3 ylo yhi\n"
    "0 4 zlo zhi\n"
    "1 0.5 -0.5 xy xz yz\n"
    "\n"
    "Masses\n"
    "\n"
    "1 1\n"
    "2 1\n"
    "\n"
    "Velocities\n"
    "\n"
    "3 .1 .2 .3 .4 .5 .6\n"
    "7 1 2 3 4 5 6\n"
    "\n"
    "Atoms # sphere\n"
    "\n"
    "7 2 3.0 1.0 2 1 2 0 -1 2\n"
    "3 1 1.0 2.0 1 -1 0 0 0 0\n";

TEST(LammpsData, ReadsAnyOrderOfSectionsAndIds) {
  const TemporaryFolder folder;
  write_file(folder / "a.data", valid_data);
  const Packing p = read_lammps_data(folder / "a.data");
  ASSERT_EQ(p.size(), 2u);
  EXPECT_EQ(p.cell.edges, (Triangle{.xx = 4, .yy = 4, .zz = 4, .yz = -0.5, .xz = 0.5, .xy = 1}));
  EXPECT_EQ(p.species, (std::vector{Species::small, Species::large}));
  EXPECT_EQ(p.radius, (std::vector{0.5, 1.5}));
  EXPECT_NEAR(p.mass[0], 2 * std::numbers::pi / 6, 1e-15);
  EXPECT_NEAR(p.mass[1], 27 * std::numbers::pi / 6, 1e-13);
  EXPECT_EQ(p.velocity[0], (Vec3<double>{0.1, 0.2, 0.3}));
  EXPECT_EQ(p.spin[1], (Vec3<double>{4, 5, 6}));
  EXPECT_EQ(p.fraction[0], Fraction{});
  EXPECT_LT(norm(p.unwrapped(1) - (Vec3<double>{1, 2, 2} + p.cell.edges * Vec3<double>{0, -1, 2})), 1e-14);
}

TEST(LammpsData, RoundTripIsExactToRounding) {
  const TemporaryFolder folder;
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Packing p = random_packing(seed);
    write_lammps_data(p, folder / "a.data");
    const Packing q = read_lammps_data(folder / "a.data");
    expect_same_packing(p, q, 1e-13);
    expect_same_unwrapped(p, q);
    EXPECT_EQ(p.cell.edges, q.cell.edges);
    for (std::size_t k = 0; k < p.size(); ++k) EXPECT_NEAR(p.mass[k] / q.mass[k], 1, 1e-15);
  }
}

TEST(LammpsData, ReadsTheReferenceStart) {
  const Packing p = read_lammps_data(test_data("a3.data"));
  ASSERT_EQ(p.size(), 320u);
  EXPECT_EQ(std::count(p.species.begin(), p.species.end(), Species::large), 20);
  EXPECT_EQ(p.cell.edges.yz, 2.6203898728861512);
  EXPECT_EQ(p.spin[1].z, -0.0016631867822320587);
  EXPECT_NEAR(p.position(1).x, 1.1314318462987931, 1e-14);
  EXPECT_NEAR(p.unwrapped(4).y, 10.616113183580959, 1e-13);
}

TEST(LammpsData, RefusesMalformedFiles) {
  const TemporaryFolder folder;
  expect_refused(
      valid_data,
      {
          {"2 atoms", "x atoms", "a.data:3: the number of particles is 'x'"},
          {"2 atoms", "0 atoms", "at least 1"},
          {"2 atoms", "-2 atoms", "at least 1"},
          {"2 atoms", "4000000000 atoms", "cannot hold"},
          {"2 atoms", "99999999999999999999 atoms", "whole number"},
          {"2 atoms", "3 atoms", "the header promises 3"},
          {"2 atoms", "1 atoms", "more lines than the 1 of the header"},
          {"2 atoms  # so many\n", "", "no line 'N atoms'"},
          {"0 bonds", "5 bonds", "unknown line in the header"},
          {"1 5 xlo xhi\n", "", "no line 'lo hi xlo xhi'"},
          {"1 5 xlo", "5 5 xlo", "above zero"},
          {"0 4 zlo", "0 -4 zlo", "above zero"},
          {"-1 3 ylo", "-1 inf ylo", "finite"},
          {"1 0.5 -0.5 xy", "1 nan -0.5 xy", "finite"},
          {"Masses", "Bonds", "a.data:11: unknown section"},
          {"Atoms # sphere", "Atoms # atomic", "another style"},
          {"Atoms # sphere", "Velocities", "second time"},
          {"7 2 3.0", "3 2 3.0", "each id of the section Atoms once"},
          {"7 1 2 3", "8 1 2 3", "a.data:19: the section Velocities must have each id"},
          {"3 .1 .2", "x .1 .2", "a.data:18: the id is 'x'"},
          {"7 2 3.0", "7 3 3.0", "type"},
          {"7 2 3.0", "7 2 0", "the diameter is '0'; it must be above zero"},
          {"7 2 3.0", "7 2 -3", "above zero"},
          {"7 2 3.0", "7 2 1e400", "the diameter is '1e400'; it must be finite"},
          {"7 2 3.0 1.0", "7 2 3.0 0", "the density"},
          {"2 1 2 0 -1 2", "2 nan 2 0 -1 2", "a.data:23: the position is 'nan'"},
          {"2 1 2 0 -1 2", "2 1e300 2 0 -1 2", "too many cells"},
          {"2 1 2 0 -1 2", "2 1 2 0 -1 9e18", "whole number"},
          {"2 1 2 0 -1 2", "2 1 2 0 -1 2000000000", "beyond 1e9"},
          {"2 1 2 0 -1 2", "2 1 2 0 -1", "9 columns"},
          {".4 .5 .6", ".4 .5", "6 columns"},
          {"3 1 1.0 2.0 1 -1 0 0 0 0\n", "", "ends after 1 lines; the header promises 2"},
          {"Atoms # sphere\n\n7 2 3.0 1.0 2 1 2 0 -1 2\n3 1 1.0 2.0 1 -1 0 0 0 0\n", "", "no section Atoms"},
      },
      folder / "a.data", read_lammps_data);
}

TEST(LammpsData, RefusesAnIdThatOccursTwice) {
  const TemporaryFolder folder;
  std::string text = valid_data;
  text.erase(text.find("Velocities"), text.find("Atoms #") - text.find("Velocities"));
  expect_refused(text, {{"7 2 3.0", "3 2 3.0", "the id 3 stands already in line"}}, folder / "a.data",
                 read_lammps_data);
}

TEST(LammpsData, SurvivesBeingCut) {
  const TemporaryFolder folder;
  expect_no_crash_when_cut(valid_data, folder / "a.data", read_lammps_data);
}

}  // namespace
}  // namespace furnas
